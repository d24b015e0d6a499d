package tellosimulator.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/**
 * Converts obstacles and mission pads to members of the page's plan, in cm and degrees clockwise.
 */
final class FloorItems {

  /** Thickness of a wall-mounted pad in the plan [m]. Decided: enough to be visible from above. */
  private static final double HANGING = 0.04;

  private FloorItems() {}

  static List<Object> of(Arena arena, ReportTexts texts) {
    List<Object> items = new ArrayList<>();
    arena.pads().forEach(pad -> items.add(pad(pad, arena, texts)));
    arena.obstacles().forEach(obstacle -> items.add(obstacle(obstacle, texts)));
    return items;
  }

  private static Map<String, Object> obstacle(Obstacle obstacle, ReportTexts texts) {
    Vec3 size = obstacle.shape().size();
    double top = obstacle.foot().z() + size.z();
    Map<String, Object> item = item(obstacle.foot(), obstacle.heading(), size);
    item.putAll(
        Json.object(
            "name", obstacle.name(),
            "label", texts.of("obstacle", obstacle.name(), cm(obstacle.foot().z()), cm(top)),
            "color", String.format(Locale.ROOT, "#%06x", obstacle.appearance().rgb()),
            "round", obstacle.shape().round(),
            "gate", obstacle.shape() instanceof Shape.Gate));
    return item;
  }

  private static Map<String, Object> pad(MissionPad pad, Arena arena, ReportTexts texts) {
    boolean hangs = pad.surface().wall();
    Pose pose = pad.pose(arena.room());
    double heading = hangs ? pad.surface().heading() : pose.attitude().heading();
    Vec3 size = new Vec3(hangs ? HANGING : MissionPad.EDGE, MissionPad.EDGE, 0);
    Map<String, Object> item = item(pose.position(), heading, size);
    item.putAll(
        Json.object(
            "name",
            texts.of("pad", pad.id()),
            "label",
            texts.of("pad", pad.id()),
            "color",
            "#ffffff",
            "round",
            false,
            "gate",
            false,
            "pad",
            pad.id()));
    return item;
  }

  private static Map<String, Object> item(Vec3 place, double heading, Vec3 size) {
    return Json.object(
        "x", cm(place.x()),
        "y", cm(place.y()),
        "heading", Frames.yawOfHeading(heading),
        "depth", cm(size.x()),
        "width", cm(size.y()));
  }

  private static long cm(double meters) {
    return Math.round(Frames.centimeters(meters));
  }
}
