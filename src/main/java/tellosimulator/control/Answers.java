package tellosimulator.control;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tellosimulator.json.Json;
import tellosimulator.junit.DroneTruth;
import tellosimulator.junit.GoalStatus;
import tellosimulator.junit.JournalEntry;
import tellosimulator.junit.Position;
import tellosimulator.junit.SimulatedDrone;

/** What the kit tells, as {@code Json} writes it: centimetres, degrees and seconds. */
final class Answers {

  private Answers() {}

  /** A row of names with their values. */
  private static Map<String, Object> object(Object... members) {
    Map<String, Object> object = new LinkedHashMap<>();
    for (int i = 0; i < members.length; i += 2) {
      object.put(String.valueOf(members[i]), members[i + 1]);
    }
    return object;
  }

  static Map<String, Object> drone(SimulatedDrone drone) {
    return object(
        "drone", drone.number(),
        "host", drone.host(),
        "commandPort", drone.commandPort(),
        "statePort", drone.statePort(),
        "videoPort", drone.videoPort());
  }

  static Map<String, Object> truth(DroneTruth truth) {
    return object(
        "x", Json.rounded(truth.position().x()),
        "y", Json.rounded(truth.position().y()),
        "z", Json.rounded(truth.position().z()),
        "height", Json.rounded(truth.height()),
        "heading", Json.rounded(truth.heading()),
        "battery", truth.battery(),
        "flying", truth.flying(),
        "landed", truth.landed(),
        "crashed", truth.crashed(),
        "takeoffs", truth.takeoffs(),
        "touched", truth.touched().stream().map(Answers::touch).toList(),
        "visited", truth.visited(),
        "highest", Json.rounded(truth.highest()),
        "farthest", Json.rounded(truth.farthest()),
        "start", place(truth.start()),
        "path", truth.path().stream().map(Answers::place).toList());
  }

  private static Map<String, Object> touch(DroneTruth.Touch touch) {
    return object(
        "what", touch.what(),
        "seconds", Json.rounded(touch.seconds()),
        "speed", Json.rounded(touch.speed()),
        "crash", touch.crash());
  }

  private static List<Double> place(Position place) {
    return List.of(Json.rounded(place.x()), Json.rounded(place.y()), Json.rounded(place.z()));
  }

  static Map<String, Object> entry(JournalEntry entry) {
    return object(
        "text", entry.text(),
        "sender", entry.sender().getAddress().getHostAddress() + ":" + entry.sender().getPort(),
        "seconds", Json.rounded(entry.seconds()),
        "outcome", entry.outcome().name().toLowerCase(Locale.ROOT).replace('_', '-'),
        "reply", entry.reply(),
        "replies", entry.replies().stream().map(Answers::reply).toList(),
        "explanation", entry.explanation());
  }

  private static Map<String, Object> reply(JournalEntry.Answer reply) {
    return object("text", reply.text(), "delay", Json.rounded(reply.delay()));
  }

  static Map<String, Object> goals(GoalStatus goals) {
    return object(
        "reached", goals.reached(),
        "failed", goals.failed(),
        "reason", goals.reason(),
        "done", goals.done(),
        "open", goals.open(),
        "seconds", Json.rounded(goals.seconds()));
  }
}
