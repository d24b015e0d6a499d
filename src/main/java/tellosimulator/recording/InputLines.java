package tellosimulator.recording;

import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.Map;
import tellosimulator.command.Peer;
import tellosimulator.json.Json;
import tellosimulator.json.JsonRecords;
import tellosimulator.sim.SimInput;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * The lines of {@code inputs.jsonl}: what a simulation began from, and what came to it between
 * which steps; see docs/recordings.md. For any thread.
 */
final class InputLines {

  private static final String STEP = "step";
  private static final String INPUT = "input";

  private InputLines() {}

  /** The first line. */
  static String text(InitialConditions start) {
    return Json.text(JsonRecords.write(InitialConditions.class, start)) + "\n";
  }

  /** What the first line says. */
  static InitialConditions start(String line) {
    return JsonRecords.read(InitialConditions.class, Json.value(line));
  }

  /** A command, of which there may be many. */
  static String text(Entry.Received datagram) {
    StringBuilder line = new StringBuilder(128);
    line.append("{\"step\":").append(step(datagram.time()));
    line.append(",\"drone\":").append(datagram.drone());
    line.append(",\"from\":\"").append(name(datagram.ends().from()));
    line.append("\",\"to\":\"").append(name(datagram.ends().to())).append("\",\"text\":");
    Json.quote(line, datagram.text());
    return line.append("}\n").toString();
  }

  private static String name(InetSocketAddress address) {
    return address.getAddress().getHostAddress() + ":" + address.getPort();
  }

  /** Something else. */
  static String text(Entry.Taken taken) {
    Map<String, Object> members = new LinkedHashMap<>();
    members.put(STEP, step(taken.time()));
    members.put(INPUT, JsonRecords.write(SimInput.class, plain(taken.input())));
    return Json.text(members) + "\n";
  }

  /** What is said in it, is said in English. */
  private static SimInput plain(SimInput input) {
    if (input instanceof SimInput.Dropped dropped) {
      Phrase reason = Phrase.of("%s", dropped.reason().english());
      return new SimInput.Dropped(dropped.drone(), dropped.host(), dropped.count(), reason);
    }
    return input;
  }

  private static long step(SimTime time) {
    return time.nanos() / SimTime.STEP_NANOS;
  }

  /**
   * What another line says.
   *
   * @throws IllegalArgumentException if it says nothing that this version knows
   */
  static RecordedInput input(String line) {
    Fields fields = Fields.of(line);
    long step =
        fields
            .large(STEP)
            .filter(each -> each >= 0 && each <= Long.MAX_VALUE / SimTime.STEP_NANOS)
            .orElseThrow(() -> new IllegalArgumentException("step is missing"));
    SimTime time = new SimTime(step * SimTime.STEP_NANOS);
    if (fields.object(INPUT).isPresent()) {
      Object input = fields.members().get(INPUT);
      return new RecordedInput(time, JsonRecords.read(SimInput.class, input));
    }
    Peer peer =
        new Peer(
            JsonRecords.socketAddress(fields.text("from")),
            JsonRecords.socketAddress(fields.text("to")));
    int drone = fields.whole("drone").orElse(1);
    return new RecordedInput(time, new SimInput.Datagram(drone, peer, fields.text("text")));
  }
}
