package tellosimulator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.recording.RecordingFixture;

/** Tests the subcommand {@code export} on the command line. */
class ExportCommandTest {

  @TempDir private Path folder;
  private String recording;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @BeforeEach
  void record() {
    Path made = RecordingFixture.in(folder.resolve("flight"));
    new RecordingFixture(made)
        .with(
            "wire.jsonl",
            "{\"t\":4,\"kind\":\"reply\",\"from\":\"127.0.0.1:1\",\"to\":\"127.0.0.1:2\",\"text\":\"ok\"}\n");
    recording = made.toString();
  }

  private int run(String... args) {
    return Main.run(
        args,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  @ParameterizedTest
  @ValueSource(strings = {"pcap", "mcap"})
  void theFileStandsInTheFolderUnlessAnotherOneIsNamed(String format) {
    Path usual = Path.of(recording, "flight." + format);
    Path named = folder.resolve("named");

    assertThat(run("export", recording, "--to", format)).isZero();
    assertThat(run("export", recording, "--to", format, "-o", named.toString())).isZero();

    assertThat(usual).isNotEmptyFile().hasSameBinaryContentAs(named);
    assertThat(out.toString(StandardCharsets.UTF_8).lines())
        .containsExactly("exported: " + usual, "exported: " + named);
    assertThat(err.size()).isZero();
  }

  @Test
  void aFolderThatIsMissingIsASentence() {
    String missing = folder.resolve("missing").toString();

    assertThat(run("export", missing, "--to", "pcap")).isEqualTo(1);

    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualToIgnoringNewLines(
            "There is no folder " + missing + "; name the folder of a recording.");
  }

  @Test
  void aFileThatCannotBeWrittenIsASentence() {
    Path nowhere = folder.resolve("no-such-folder").resolve("flight.pcap");

    assertThat(run("export", recording, "--to", "pcap", "-o", folder.toString())).isEqualTo(1);
    assertThat(run("export", recording, "--to", "pcap", "-o", nowhere.toString())).isEqualTo(1);

    assertThat(err.toString(StandardCharsets.UTF_8).lines())
        .containsExactly(
            "The recording was not exported to %1$s: %1$s is a folder, a pipe or a device, not a file."
                .formatted(folder),
            "The recording was not exported to %1$s: there is no folder for %1$s."
                .formatted(nowhere));
    assertThat(out.size()).isZero();
  }

  @Test
  void theFormatMustBeNamed() {
    assertThat(run("export", recording)).isEqualTo(2);

    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualToIgnoringNewLines("Missing required option: '--to=pcap|mcap'. Try --help.");
  }
}
