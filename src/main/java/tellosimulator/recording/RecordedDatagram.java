package tellosimulator.recording;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.OptionalInt;

/**
 * A line of {@code wire.jsonl}. Immutable.
 *
 * @param time when the datagram was applied or sent, in simulated seconds since the simulation
 *     began
 * @param drone the drone's number, from 1
 * @param kind {@code command}, {@code reply}, {@code state} or {@code video}
 * @param from the host and port of the sender, such as {@code 127.0.0.1:8889}
 * @param to the host and port of the receiver
 * @param text the payload, one character for each byte (ISO-8859-1); empty for video
 * @param videoSize size of a video datagram [bytes]; its contents are not recorded
 */
public record RecordedDatagram(
    double time,
    int drone,
    String kind,
    String from,
    String to,
    String text,
    OptionalInt videoSize) {

  /** Maximum length of a payload [bytes]. Documented: RFC 768 and RFC 791. */
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
   * Passes all datagrams of a recording to a sink one at a time, because they may not fit into
   * memory. Damaged lines are skipped.
   *
   * @param folder the folder of a recording; it may contain no datagrams
   * @throws IOException if the datagrams cannot be read
   */
  public static void readAll(Path folder, LineReader.Sink<RecordedDatagram> sink)
      throws IOException {
    LineReader.readAll(RecordingFile.WIRE.in(folder), line -> sink.accept(of(Fields.of(line))));
  }

  /** The payload, as far as it is recorded. */
  public byte[] payload() {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Whether UDP can carry a payload of this size. */
  public boolean isPossible() {
    return length() >= 0 && length() <= LONGEST && text.length() <= LONGEST;
  }

  /** The length of the payload [bytes]. */
  public int length() {
    return videoSize.orElse(text.length());
  }
}
