package tellosimulator.recording;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Room;

/** What {@code run.json} says, at the beginning and at the end. For the writer's thread. */
final class RunText {

  private final Map<String, Object> members = new LinkedHashMap<>();

  private RunText() {
    members.put("format", RecordedRun.FORMAT);
    members.put("program", RecordedRun.version());
  }

  private void putTimes(String factor, Entry.Begin begin) {
    members.put("timeFactor", factor);
    members.put("begun", begin.wall().iso());
    members.put("started", Json.rounded(begin.time().seconds()));
  }

  /** Of a simulated flight. */
  static RunText of(FlightRecorder.Subject subject, Entry.Begin begin, InputHistory inputs) {
    SimSnapshot snapshot = begin.snapshot().orElseThrow();
    RunText text = new RunText();
    Map<String, Object> members = text.members;
    members.put("seed", subject.scenario().config().seed());
    text.putTimes(factor(snapshot.clock().factor()), begin);
    members.put("scenario", subject.title());
    members.put("room", room(snapshot.room()));
    members.put("drones", snapshot.drones().stream().map(RunText::drone).toList());
    members.put("options", subject.options());
    if (inputs.begun()) {
      members.put("inputs", inputs.complete() ? "all" : "incomplete");
    }
    return text;
  }

  /**
   * Of the flight of a real drone, of which only the wire is known.
   *
   * @param drone its address
   * @param options words of the command line
   */
  static RunText of(InetAddress drone, List<String> options, Entry.Begin begin) {
    RunText text = new RunText();
    text.members.put("realDrone", drone.getHostAddress());
    text.putTimes("1", begin);
    text.members.put("drones", List.of(Map.of("number", 1)));
    text.members.put("options", options);
    return text;
  }

  private static String factor(TimeFactor factor) {
    return factor.toString().replaceFirst("\\.0$", "");
  }

  private static Map<String, Object> room(Room room) {
    Map<String, Object> sizes = new LinkedHashMap<>();
    sizes.put("width", centimeters(room.width()));
    sizes.put("depth", centimeters(room.depth()));
    sizes.put("height", centimeters(room.height()));
    return sizes;
  }

  private static Map<String, Object> drone(DroneSnapshot drone) {
    Map<String, Object> start = new LinkedHashMap<>();
    Vec3 place = drone.start().position();
    start.put("x", centimeters(place.x()));
    start.put("y", centimeters(place.y()));
    start.put("heading", Json.rounded(Frames.yawOfHeading(drone.start().attitude().heading())));
    Map<String, Object> members = new LinkedHashMap<>();
    members.put("number", drone.state().drone());
    members.put("profile", drone.product().profile().option());
    members.put("behaviour", drone.product().behavior().option());
    members.put("start", start);
    Rgb color = Livery.of(drone).color();
    members.put("color", String.format(Locale.ROOT, "#%06x", color.argb() & 0xffffff));
    return members;
  }

  /** The text while the flight goes on. */
  String begun() {
    return Json.text(members);
  }

  /** The text of the whole flight. */
  String ended(Entry.End end, List<VideoRecorders.Kept> films) {
    members.put("ended", Json.rounded(end.time().seconds()));
    members.put("result", end.goals().word());
    List<Object> videos = new ArrayList<>();
    for (VideoRecorders.Kept film : films) {
      Map<String, Object> video = new LinkedHashMap<>();
      video.put("drone", film.drone());
      video.put("file", film.file());
      video.put("started", Json.rounded(film.begun().seconds()));
      videos.add(video);
    }
    if (!videos.isEmpty()) {
      members.put("videos", videos);
    }
    return Json.text(members);
  }

  private static double centimeters(double meters) {
    return Json.rounded(Frames.centimeters(meters));
  }
}
