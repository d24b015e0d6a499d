package tellosimulator.recording;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;

/**
 * A line of {@code wire.jsonl}. Immutable; for any thread.
 *
 * @param time when it was taken or sent, simulated seconds since the simulation began
 * @param drone its number, from 1
 * @param kind {@code command}, {@code reply}, {@code state} or {@code video}
 * @param from host and port, as {@code 127.0.0.1:8889}
 * @param to host and port
 * @param text one character a byte (ISO-8859-1); empty for video
 * @param videoSize of video alone, whose bytes are not kept
 */
public record RecordedDatagram(
    double time,
    int drone,
    String kind,
    String from,
    String to,
    String text,
    OptionalInt videoSize) {

  /** The longest payload [bytes]. Documented: RFC 768 within RFC 791. */
  private static final int LONGEST = 65_507;

  static RecordedDatagram of(Fields fields) {
    return new RecordedDatagram(
        fields.moment("t").orElse(0),
        fields.whole("drone").orElse(1),
        fields.text("kind"),
        fields.text("from"),
        fields.text("to"),
        fields.text("text"),
        fields.whole("size"));
  }

  /**
   * Hands on all of a recording, one after another: they may be more than fit into memory. Those
   * that are damaged are left out.
   *
   * @param folder of a recording; nothing happens if it keeps none
   * @throws IOException if they cannot be read
   */
  public static void readAll(Path folder, Consumer<RecordedDatagram> consumer) throws IOException {
    try (LineReader reader = new LineReader(RecordingFile.WIRE.in(folder))) {
      for (Optional<String> line = reader.next(); line.isPresent(); line = reader.next()) {
        try {
          consumer.accept(of(Fields.of(line.get())));
        } catch (IllegalArgumentException e) {
          // it is damaged
        }
      }
    }
  }

  /** What was in it, as far as it is kept. */
  public byte[] payload() {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Whether UDP can carry it. */
  public boolean isPossible() {
    return length() >= 0 && length() <= LONGEST && text.length() <= LONGEST;
  }

  /** How long it was [bytes]. */
  public int length() {
    return videoSize.orElse(text.length());
  }
}
