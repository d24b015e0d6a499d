package tellosimulator.export;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.recording.RecordedDatagram;
import tellosimulator.recording.RecordedEvent;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.Sample;
import tellosimulator.recording.StateNumbers;
import tellosimulator.recording.Track;

/**
 * A recording as channels of messages: {@code /drone1/truth} (where the drone was), {@code
 * /drone1/state} (the numbers of its state lines), {@code /events} and {@code /wire}. Times are
 * those of {@link ExportClock}. For one thread.
 */
final class McapExport {

  private static final String TRUTH_SCHEMA =
      schema("x_cm", "y_cm", "z_cm", "roll_deg", "pitch_deg", "heading_deg", "battery_pct");

  private static final String STATE_SCHEMA = schema("pitch", "roll", "yaw", "h", "tof", "bat");

  private static final String ANY_SCHEMA = "{\"type\":\"object\"}";

  private final McapFile file;
  private final ExportClock clock;
  private final Map<String, Integer> channels = new HashMap<>();

  private McapExport(McapFile file, ExportClock clock) {
    this.file = file;
    this.clock = clock;
  }

  private static String schema(String... numbers) {
    StringBuilder properties = new StringBuilder();
    for (String number : numbers) {
      properties
          .append(properties.length() == 0 ? "" : ",")
          .append('"')
          .append(number)
          .append("\":{\"type\":\"number\"}");
    }
    return "{\"type\":\"object\",\"properties\":{" + properties + "}}";
  }

  /**
   * Writes the file.
   *
   * @param folder in which the recording is
   * @throws IOException if the recording cannot be read, or the file cannot be written
   */
  static void write(Path folder, RecordedFlight flight, OutputStream out) throws IOException {
    McapFile file = new McapFile(out, "tello-simulator " + flight.run().program());
    McapExport export = new McapExport(file, new ExportClock(flight.run()));
    List<Track> tracks = flight.run().realDrone().isPresent() ? List.of() : flight.tracks();
    for (Track track : tracks) {
      for (Sample sample : track.samples()) {
        export.add(track.drone(), sample);
      }
    }
    for (RecordedEvent event : flight.events()) {
      export.add(event);
    }
    try {
      RecordedDatagram.readAll(folder, export::add);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    if (export.channels.isEmpty()) {
      throw new IOException("nothing of it is known");
    }
    file.end();
  }

  private void add(int drone, Sample sample) throws IOException {
    Map<String, Object> message = new LinkedHashMap<>();
    message.put("x_cm", Frames.centimeters(sample.position().x()));
    message.put("y_cm", Frames.centimeters(sample.position().y()));
    message.put("z_cm", Frames.centimeters(sample.position().z()));
    message.put("roll_deg", sample.angles().roll());
    message.put("pitch_deg", sample.angles().pitch());
    message.put("heading_deg", sample.angles().heading());
    message.put("battery_pct", sample.batteryPercent());
    message.put("phase", sample.phase());
    message.put("command", sample.command());
    send("/drone" + drone + "/truth", "truth", TRUTH_SCHEMA, sample.time(), message);
  }

  private void add(RecordedEvent event) throws IOException {
    Map<String, Object> message = new LinkedHashMap<>();
    event.drone().ifPresent(drone -> message.put("drone", drone));
    message.put("kind", event.kind());
    message.put("severity", event.severity());
    message.put("text", event.text());
    send("/events", "event", ANY_SCHEMA, event.time(), message);
  }

  private void add(RecordedDatagram datagram) {
    Map<String, Object> message = new LinkedHashMap<>();
    message.put("drone", datagram.drone());
    message.put("kind", datagram.kind());
    message.put("from", datagram.from());
    message.put("to", datagram.to());
    message.put("bytes", datagram.length());
    message.put("text", datagram.text());
    try {
      send("/wire", "datagram", ANY_SCHEMA, datagram.time(), message);
      if (datagram.kind().equals("state")) {
        String topic = "/drone" + datagram.drone() + "/state";
        send(topic, "state", STATE_SCHEMA, datagram.time(), StateNumbers.of(datagram.text()));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void send(
      String topic, String schemaName, String schema, double time, Map<String, ?> message)
      throws IOException {
    Integer channel = channels.get(topic);
    if (channel == null) {
      channel = file.channel(topic, schemaName, schema);
      channels.put(topic, channel);
    }
    file.message(channel, 1000 * clock.micros(time), Json.text(message));
  }
}
