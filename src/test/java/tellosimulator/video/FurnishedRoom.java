package tellosimulator.video;

import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import tellosimulator.math.Vec3;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.ObstacleAppearance.Side;
import tellosimulator.world.Shape;

/** A room with one obstacle of each kind, and all mission pads. */
final class FurnishedRoom {

  private static final Map<Side, String> MARKERS =
      Map.of(Side.BACK, "examples/marker.png", Side.TOP, "examples/marker.png");

  static final Arena ARENA =
      Arena.DEFAULT
          .withObstacles(
              List.of(
                  thing(
                      new Shape.Box(0.5, 0.5, 0.5),
                      new Vec3(1.2, 0.9, 0),
                      painted(0xc62828, Pattern.PLAIN)),
                  thing(
                      new Shape.Box(0.4, 0.4, 0.4),
                      new Vec3(1.3, 0.9, 0.5),
                      painted(0x1565c0, Pattern.STRIPES)),
                  thing(
                      new Shape.Box(0.12, 1.4, 1.2),
                      new Vec3(2, -0.9, 0),
                      painted(0xb5523b, Pattern.BRICKS)),
                  thing(
                      new Shape.Cylinder(0.25, 0.5),
                      new Vec3(0.5, -1.1, 0),
                      painted(0x6a1b9a, Pattern.CHECKS)),
                  thing(
                      new Shape.Box(0.3, 0.3, 0.3),
                      new Vec3(0.4, -0.5, 0),
                      new ObstacleAppearance(0x888888, Pattern.PLAIN, MARKERS)),
                  thing(
                      new Shape.Ring(0.35, 0.06, 1.2),
                      new Vec3(1.5, 0, 0),
                      painted(0xe53935, Pattern.PLAIN)),
                  thing(
                      new Shape.Frame(0.6, 0.6, 0.06, 1.3),
                      new Vec3(0.9, -0.75, 0),
                      painted(0xff6f00, Pattern.STRIPES))))
          .withPads(
              IntStream.rangeClosed(1, MissionPad.LAST_ID).mapToObj(FurnishedRoom::pad).toList());

  private FurnishedRoom() {}

  static ObstacleAppearance painted(int rgb, Pattern pattern) {
    return new ObstacleAppearance(rgb, pattern, Map.of());
  }

  /** An obstacle, turned a little. */
  private static Obstacle thing(Shape shape, Vec3 foot, ObstacleAppearance appearance) {
    return new Obstacle("thing", shape, foot, 0.3, appearance);
  }

  /** A mission pad in one of two rows of four. */
  private static MissionPad pad(int id) {
    int row = (id - 1) / 4;
    int column = (id - 1) % 4;
    return MissionPad.onFloor(id, new Vec3(-0.8 + 0.3 * row, 0.45 - 0.3 * column, 0), 0.2 * id);
  }
}
