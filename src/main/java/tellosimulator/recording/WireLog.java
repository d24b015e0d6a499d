package tellosimulator.recording;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
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
    try (LineReader reader = new LineReader(RecordingFile.WIRE.in(folder))) {
      for (Optional<String> line = reader.next(); line.isPresent(); line = reader.next()) {
        try {
          consumer.accept(RecordedDatagram.of(Fields.of(line.get())));
        } catch (IllegalArgumentException e) {
          // it is damaged
        }
      }
    }
  }
}
