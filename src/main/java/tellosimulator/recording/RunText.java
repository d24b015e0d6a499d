package tellosimulator.recording;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import tellosimulator.goal.Goal;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.recording.VideoRecorders.RecordedVideo;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Room;

/**
 * Formats {@code run.json} at the beginning and at the end of a flight, and {@code goals.json}.
 * Confined to the writer's thread.
 */
final class RunText {

  private final Map<String, Object> members;

  private RunText(Map<String, Object> members) {
    this.members = members;
  }

  /** Creates the formatter for a simulated flight. */
  static RunText of(FlightRecorder.Subject subject, Entry.Begin begin, InputHistory inputs) {
    SimSnapshot snapshot = begin.snapshot().orElseThrow();
    String known = inputs.complete() ? "all" : "incomplete";
    return new RunText(
        Json.object(
            "format", RecordedRun.FORMAT,
            "program", RecordedRun.version(),
            "seed", subject.scenario().config().seed(),
            "timeFactor", factor(snapshot.clock().factor()),
            "begun", begin.wall().iso(),
            "started", begin.time().seconds(),
            "scenario", subject.title(),
            "room", room(snapshot.room()),
            "drones", snapshot.drones().stream().map(RunText::drone).toList(),
            "options", subject.options(),
            "inputs", inputs.begun() ? Optional.of(known) : Optional.empty()));
  }

  /**
   * Creates the formatter for the flight of a real drone.
   *
   * @param drone the drone's address
   * @param options the command-line arguments
   */
  static RunText of(InetAddress drone, List<String> options, Entry.Begin begin) {
    return new RunText(
        Json.object(
            "format", RecordedRun.FORMAT,
            "program", RecordedRun.version(),
            "realDrone", drone.getHostAddress(),
            "timeFactor", "1",
            "begun", begin.wall().iso(),
            "started", begin.time().seconds(),
            "drones", List.of(Map.of("number", 1)),
            "options", options));
  }

  private static String factor(TimeFactor factor) {
    return factor.toString().replaceFirst("\\.0$", "");
  }

  private static Map<String, Object> room(Room room) {
    return Json.object(
        "width", Frames.centimeters(room.width()),
        "depth", Frames.centimeters(room.depth()),
        "height", Frames.centimeters(room.height()));
  }

  private static Map<String, Object> drone(DroneSnapshot drone) {
    Vec3 place = drone.start().position();
    int rgb = Livery.of(drone).color().argb() & 0xffffff;
    return Json.object(
        "number", drone.state().drone(),
        "profile", drone.product().profile().option(),
        "behaviour", drone.product().behavior().option(),
        "start",
            Json.object(
                "x", Frames.centimeters(place.x()),
                "y", Frames.centimeters(place.y()),
                "heading", Frames.yawOfHeading(drone.start().attitude().heading())),
        "color", String.format(Locale.ROOT, "#%06x", rgb));
  }

  /** The text during the flight. */
  String begun() {
    return Json.text(members);
  }

  /** The text of the finished flight. */
  String ended(Entry.End end, List<RecordedVideo> films) {
    List<Map<String, Object>> videos = films.stream().map(RunText::video).toList();
    members.putAll(
        Json.object(
            "ended", end.time().seconds(),
            "result", end.word(),
            "score", RecordedScore.members(end),
            "videos", Optional.of(videos).filter(all -> !all.isEmpty())));
    return Json.text(members);
  }

  private static Map<String, Object> video(RecordedVideo film) {
    return Json.object(
        "drone", film.drone(), "file", film.file(), "started", film.begun().seconds());
  }

  /** Formats the goals, each with the time at which it was reached. */
  static String goals(Entry.End end) {
    List<Object> goals = new ArrayList<>();
    List<Goal> asked = end.progress().challenge().goals();
    for (int i = 0; i < asked.size(); i++) {
      OptionalDouble after = end.progress().reached().get(i);
      goals.add(
          Json.object(
              "text", asked.get(i).phrase().english(),
              "said", RecordedPhrase.members(asked.get(i).phrase()),
              "reached",
                  after.stream()
                      .map(each -> end.attemptNanos() * 1e-9 + each)
                      .boxed()
                      .findFirst()));
    }
    return Json.text(goals);
  }
}
