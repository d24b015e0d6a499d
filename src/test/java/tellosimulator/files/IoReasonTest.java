package tellosimulator.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class IoReasonTest {

  @Test
  void eachIsAClauseForPeople() {
    assertThat(clause(new AccessDeniedException("/a"))).isEqualTo("you may not write to /a");
    assertThat(clause(new FileAlreadyExistsException("/a"))).isEqualTo("/a is in the way");
    assertThatThrownBy(() -> IrregularFileException.check(Path.of("/dev/null")))
        .isInstanceOfSatisfying(
            IOException.class,
            e ->
                assertThat(clause(e))
                    .isEqualTo("/dev/null is a folder, a pipe or a device, not a file"));
    assertThat(clause(new NoSuchFileException("/a"))).isEqualTo("there is no folder for /a");
    assertThat(clause(new FileSystemException("/a", null, "No space left on device")))
        .isEqualTo("No space left on device");
    assertThat(clause(new IOException("No space left on device")))
        .isEqualTo("No space left on device");
    assertThat(clause(new ClosedChannelException())).isEqualTo("the system does not say why");
    assertThat(IoReason.ofReading(new AccessDeniedException("/a")))
        .isEqualTo("you may not read it");
    assertThat(IoReason.ofReading(new NoSuchFileException("/a")))
        .isEqualTo("there is no such file");
    assertThat(IoReason.ofReading(new IOException("is a directory"))).isEqualTo("is a directory");
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          from/wire.jsonl,   from/wire.jsonl cannot be read: you may not read it
          from/out/run.json, you may not write to from/out/run.json
          from/out,          you may not write to from/out
          from,              you may not write to from
          """)
  void whatWasReadIsToldApartFromWhatWasWritten(String file, String clause) {
    assertThat(IoReason.of(new AccessDeniedException(file), Path.of("from", "out")))
        .isEqualTo(clause);
  }

  @Test
  void whatNamesNoFileIsToldAsItIs() {
    assertThat(IoReason.of(new IOException("no drone took off"), Path.of("out")))
        .isEqualTo("no drone took off");
  }

  private static String clause(IOException e) {
    return IoReason.of(e).toString();
  }
}
