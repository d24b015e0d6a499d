package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LineReaderTest {

  @TempDir private Path folder;

  private List<String> lines(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("lines"), text);
    List<String> lines = new ArrayList<>();
    try (LineReader reader = new LineReader(file)) {
      for (Optional<String> line = reader.next(); line.isPresent(); line = reader.next()) {
        lines.add(line.get());
      }
      assertThat(reader.next()).isEmpty();
    }
    return lines;
  }

  @Test
  void linesComeInOrderWithoutTheirEnds() throws IOException {
    assertThat(lines("one\n\nthree: ä€\n")).containsExactly("one", "", "three: ä€");
  }

  @Test
  void whatWasCutOffIsLeftOut() throws IOException {
    assertThat(lines("one\ntw")).containsExactly("one");
    assertThat(lines("on")).isEmpty();
    assertThat(lines("")).isEmpty();
  }

  /** The buffer has 65,536 bytes. */
  @Test
  void linesMayBeLongerThanTheBufferAndEndAnywhereInIt() throws IOException {
    List<String> lines =
        List.of("a".repeat(65_535), "b", "c".repeat(200_000), "", "d".repeat(65_536), "e");

    assertThat(lines(String.join("\n", lines) + "\n")).isEqualTo(lines);
  }

  @Test
  void aMissingFileHasNoLines() throws IOException {
    try (LineReader reader = new LineReader(folder.resolve("missing"))) {
      assertThat(reader.next()).isEmpty();
    }
  }
}
