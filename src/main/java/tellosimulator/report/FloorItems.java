package tellosimulator.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.world.Arena;
import tellosimulator.world.Footprint;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/** Obstacles and mission pads as the page's plan has them, in cm and degrees clockwise. */
final class FloorItems {

  /** Thickness of a pad that hangs [m]. Decided: to be seen from above. */
  private static final double HANGING = 0.04;

  private FloorItems() {}

  static List<Object> of(Arena arena, ReportTexts texts) {
    List<Object> items = new ArrayList<>();
    arena.pads().forEach(pad -> items.add(pad(pad, arena, texts)));
    arena.obstacles().forEach(obstacle -> items.add(obstacle(obstacle, texts)));
    return items;
  }

  private static Map<String, Object> obstacle(Obstacle obstacle, ReportTexts texts) {
    Vec3 size = Footprint.size(obstacle.shape());
    double top = obstacle.foot().z() + size.z();
    Map<String, Object> item = item(obstacle.foot(), obstacle.heading(), size);
    item.put("name", obstacle.name());
    item.put("label", texts.of("obstacle", obstacle.name(), cm(obstacle.foot().z()), cm(top)));
    item.put("color", String.format(Locale.ROOT, "#%06x", obstacle.appearance().rgb()));
    item.put("round", obstacle.shape() instanceof Shape.Cylinder);
    item.put("gate", obstacle.shape() instanceof Shape.Gate);
    return item;
  }

  private static Map<String, Object> pad(MissionPad pad, Arena arena, ReportTexts texts) {
    boolean hangs = pad.surface().wall();
    Pose pose = pad.pose(arena.room());
    double heading = hangs ? pad.surface().heading() : pose.attitude().heading();
    Vec3 size = new Vec3(hangs ? HANGING : MissionPad.EDGE, MissionPad.EDGE, 0);
    Map<String, Object> item = item(pose.position(), heading, size);
    item.put("name", texts.of("pad", pad.id()));
    item.put("label", texts.of("pad", pad.id()));
    item.put("color", "#ffffff");
    item.put("round", false);
    item.put("gate", false);
    item.put("pad", pad.id());
    return item;
  }

  private static Map<String, Object> item(Vec3 place, double heading, Vec3 size) {
    Map<String, Object> item = new LinkedHashMap<>();
    item.put("x", cm(place.x()));
    item.put("y", cm(place.y()));
    item.put("heading", Json.rounded(Frames.yawOfHeading(heading)));
    item.put("depth", cm(size.x()));
    item.put("width", cm(size.y()));
    return item;
  }

  private static long cm(double meters) {
    return Math.round(Frames.centimeters(meters));
  }
}
