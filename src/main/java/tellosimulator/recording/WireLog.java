package tellosimulator.recording;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;

/** The datagrams of a recording, which may be more than fit into memory. */
public final class WireLog {

  private WireLog() {}

  /**
   * Hands on the lines of {@code wire.jsonl}, one after another. Those that are damaged are left
   * out.
   *
   * @param folder of a recording; nothing happens if there is no such file in it
   * @throws IOException if the file cannot be read
   */
  public static void read(Path folder, Consumer<RecordedDatagram> consumer) throws IOException {
    Path wire = folder.resolve("wire.jsonl");
    if (!Files.isRegularFile(wire)) {
      return;
    }
    try (BufferedReader reader = Files.newBufferedReader(wire, StandardCharsets.ISO_8859_1)) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        try {
          consumer.accept(RecordedDatagram.of(Fields.of(line)));
        } catch (IllegalArgumentException e) {
          // it was cut off
        }
      }
    }
  }
}
