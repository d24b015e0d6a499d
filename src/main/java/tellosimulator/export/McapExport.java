package tellosimulator.export;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.recording.FlightCsvReader;
import tellosimulator.recording.RecordedDatagram;
import tellosimulator.recording.RecordedEvent;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.ReportedState;
import tellosimulator.recording.Sample;

/**
 * Exports a recording as channels of JSON messages in an MCAP file for Foxglove and PlotJuggler:
 * {@code /events}, {@code /wire}, and channels for each drone. For drone 1, these are {@code
 * /drone1/truth} (its recorded motion, if the drone is simulated) and {@code /drone1/state} (the
 * numbers in its state lines). The file has no chunks and no index; both are optional in the
 * format. Not thread-safe.
 *
 * <p>Source: MCAP format specification, version 0.
 */
final class McapExport {

  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

  private static final int HEADER = 0x01;
  private static final int FOOTER = 0x02;
  private static final int SCHEMA = 0x03;
  private static final int CHANNEL = 0x04;
  private static final int MESSAGE = 0x05;
  private static final int DATA_END = 0x0f;

  private static final String TRUTH_SCHEMA =
      schema("x_cm", "y_cm", "z_cm", "roll_deg", "pitch_deg", "heading_deg", "battery_pct");

  private static final String STATE_SCHEMA = schema("pitch", "roll", "yaw", "h", "tof", "bat");

  private static final String ANY_SCHEMA = "{\"type\":\"object\"}";

  private final OutputStream out;
  private final ExportFormat.Clock clock;
  private final Map<String, Integer> channels = new HashMap<>();
  private int messages;

  private McapExport(OutputStream out, ExportFormat.Clock clock) {
    this.out = out;
    this.clock = clock;
  }

  private static String schema(String... numbers) {
    return Stream.of(numbers)
        .map(number -> "\"" + number + "\":{\"type\":\"number\"}")
        .collect(Collectors.joining(",", "{\"type\":\"object\",\"properties\":{", "}}"));
  }

  /**
   * Writes the file.
   *
   * @param folder the recording's folder
   * @throws IOException if the recording cannot be read, or the file cannot be written
   */
  static void write(Path folder, RecordedFlight flight, OutputStream out) throws IOException {
    McapExport export = new McapExport(out, new ExportFormat.Clock(flight.run()));
    out.write(MAGIC);
    String program = "tello-simulator " + flight.run().program();
    export.write(HEADER, new Content().text("").text(program));
    if (flight.run().realDrone().isEmpty()) {
      FlightCsvReader.readAll(folder, export::add);
    }
    RecordedEvent.readAll(folder, export::add);
    RecordedDatagram.readAll(folder, export::add);
    if (export.channels.isEmpty()) {
      throw new IOException("nothing of it is known");
    }
    export.write(DATA_END, new Content().number(0, 4)); // no checksum
    export.write(FOOTER, new Content().number(0, 8).number(0, 8).number(0, 4)); // no summary
    out.write(MAGIC);
  }

  private void add(int drone, Sample sample) throws IOException {
    Map<String, Object> message =
        Json.object(
            "x_cm", Frames.centimeters(sample.position().x()),
            "y_cm", Frames.centimeters(sample.position().y()),
            "z_cm", Frames.centimeters(sample.position().z()),
            "roll_deg", sample.angles().roll(),
            "pitch_deg", sample.angles().pitch(),
            "heading_deg", sample.angles().heading(),
            "battery_pct", sample.batteryPercent(),
            "phase", sample.phase(),
            "command", sample.command());
    send("/drone" + drone + "/truth", TRUTH_SCHEMA, sample.time(), message);
  }

  private void add(RecordedEvent event) throws IOException {
    Map<String, Object> message =
        Json.object(
            "drone", event.drone(),
            "kind", event.kind(),
            "severity", event.severity(),
            "text", event.phrase().english());
    send("/events", ANY_SCHEMA, event.time(), message);
  }

  private void add(RecordedDatagram datagram) throws IOException {
    Map<String, Object> message =
        Json.object(
            "drone", datagram.drone(),
            "kind", datagram.kind(),
            "from", datagram.from(),
            "to", datagram.to(),
            "bytes", datagram.length(),
            "text", datagram.text(),
            "words", NamedPacket.of(datagram.payload()).map(NamedPacket::words));
    send("/wire", ANY_SCHEMA, datagram.time(), message);
    if (datagram.kind().equals("state")) {
      String topic = "/drone" + datagram.drone() + "/state";
      send(topic, STATE_SCHEMA, datagram.time(), ReportedState.numbers(datagram.text()));
    }
  }

  private void send(String topic, String schema, double time, Map<String, ?> message)
      throws IOException {
    if (!channels.containsKey(topic)) {
      channels.put(topic, channels.size() + 1);
      addChannel(channels.size(), topic, schema);
    }
    long nanos = 1000 * clock.micros(time);
    Content content = new Content().number(channels.get(topic), 2).number(messages++, 4);
    content.number(nanos, 8).number(nanos, 8);
    content.writeBytes(Json.text(message).getBytes(StandardCharsets.US_ASCII));
    write(MESSAGE, content);
  }

  private void addChannel(int number, String topic, String schema) throws IOException {
    String name = topic.substring(topic.lastIndexOf('/') + 1);
    write(SCHEMA, new Content().number(number, 2).text(name).text("jsonschema").text(schema));
    Content channel = new Content().number(number, 2).number(number, 2).text(topic).text("json");
    write(CHANNEL, channel.number(0, 4));
  }

  private void write(int opcode, Content content) throws IOException {
    out.write(opcode);
    new Content().number(content.size(), 8).writeTo(out);
    content.writeTo(out);
  }

  /** The content of a record, with numbers in little-endian order. */
  private static final class Content extends ByteArrayOutputStream {

    Content number(long value, int bytes) {
      for (int i = 0; i < bytes; i++) {
        write((int) (value >> (8 * i)));
      }
      return this;
    }

    Content text(String text) {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      number(bytes.length, 4).writeBytes(bytes);
      return this;
    }
  }
}
