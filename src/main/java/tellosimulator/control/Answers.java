package tellosimulator.control;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import tellosimulator.json.Json;
import tellosimulator.junit.DroneTruth;
import tellosimulator.junit.GoalStatus;
import tellosimulator.junit.JournalEntry;
import tellosimulator.junit.Position;
import tellosimulator.junit.ScoreStatus;
import tellosimulator.junit.SimulatedDrone;

/**
 * Converts values of the test kit to maps for {@code Json}, in centimetres, degrees and seconds.
 */
final class Answers {

  private Answers() {}

  static Map<String, Object> drone(SimulatedDrone drone) {
    return Json.object(
        "drone", drone.number(),
        "host", drone.host(),
        "commandPort", drone.commandPort(),
        "statePort", drone.statePort(),
        "videoPort", drone.videoPort());
  }

  static Map<String, Object> truth(DroneTruth truth) {
    return Json.object(
        "x", truth.position().x(),
        "y", truth.position().y(),
        "z", truth.position().z(),
        "height", truth.height(),
        "heading", truth.heading(),
        "battery", truth.battery(),
        "flying", truth.flying(),
        "landed", truth.landed(),
        "crashed", truth.crashed(),
        "takeoffs", truth.takeoffs(),
        "touched", truth.touched().stream().map(Answers::touch).toList(),
        "visited", truth.visited(),
        "highest", truth.highest(),
        "farthest", truth.farthest(),
        "start", place(truth.start()),
        "path", truth.path().stream().map(Answers::place).toList());
  }

  private static Map<String, Object> touch(DroneTruth.Touch touch) {
    return Json.object(
        "what", touch.what(),
        "seconds", touch.seconds(),
        "speed", touch.speed(),
        "crash", touch.crash());
  }

  private static List<Double> place(Position place) {
    return List.of(Json.rounded(place.x()), Json.rounded(place.y()), Json.rounded(place.z()));
  }

  static Map<String, Object> entry(JournalEntry entry) {
    return Json.object(
        "text", entry.text(),
        "sender", entry.sender().getAddress().getHostAddress() + ":" + entry.sender().getPort(),
        "seconds", entry.seconds(),
        "outcome", entry.outcome().name().toLowerCase(Locale.ROOT).replace('_', '-'),
        "reply", entry.reply(),
        "replies", entry.replies().stream().map(Answers::reply).toList(),
        "explanation", entry.explanation());
  }

  private static Map<String, Object> reply(JournalEntry.Answer reply) {
    return Json.object("text", reply.text(), "delay", reply.delay());
  }

  static Map<String, Object> goals(GoalStatus goals) {
    return Json.object(
        "reached", goals.reached(),
        "failed", goals.failed(),
        "reason", goals.reason(),
        "done", goals.done(),
        "open", goals.open(),
        "seconds", goals.seconds(),
        "score", goals.score().map(Answers::score));
  }

  private static Map<String, Object> score(ScoreStatus score) {
    return Json.object(
        "points", score.points(),
        "of", score.of(),
        "entries", score.entries().stream().map(Answers::entry).toList());
  }

  private static Map<String, Object> entry(ScoreStatus.Entry entry) {
    return Json.object("seconds", entry.seconds(), "points", entry.points(), "why", entry.why());
  }
}
