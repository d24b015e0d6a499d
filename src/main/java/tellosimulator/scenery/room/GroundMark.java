package tellosimulator.scenery.room;

import java.util.Arrays;
import java.util.List;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.paint.Sketch;
import tellosimulator.scenery.paint.Sketch.Arc;
import tellosimulator.scenery.paint.Sketch.Point;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.scenery.room.Quads.Quad;
import tellosimulator.world.Arena;

/** What a drone leaves on the floor: its shadow, and the mark where it starts. For any thread. */
public final class GroundMark {

  /** Edge of the start mark [m]. Decided: the drone covers the ring only in part. */
  private static final double START_SIZE = 0.42;

  /** Decided: the floor shines through. */
  private static final double START_OPACITY = 0.8;

  private static final int START_PICTURE = 256;

  private static final int SHADOW_PICTURE = 64;

  /** What is the same for all drones; made when the first drone is. */
  private static final class Shared {

    static final Mesh START_MESH = new Quads().add(Quad.onFloor(START_SIZE), Patch.WHOLE).mesh();
    static final Sketch START = startMark();
    static final Part SHADOW =
        new Part(new Quads().add(Quad.onFloor(2), Patch.WHOLE).mesh(), shadowSpot(), Finish.DECAL);
  }

  private final Part start;

  /**
   * @param livery the drone's colours
   */
  public GroundMark(Livery livery) {
    start =
        new Part(Shared.START_MESH, Shared.START.texture(livery.color().paler(0.85)), Finish.DECAL);
  }

  /**
   * The mark where a drone starts.
   *
   * @param pose where a reset puts the drone, room frame
   */
  public Placed start(Pose pose) {
    return new Placed(start, onFloor(pose), 1, START_OPACITY);
  }

  /**
   * The shadow of a drone, on what is right under it.
   *
   * @param position of the drone, room frame [m]
   */
  public static Placed shadow(Underneath underneath, Arena arena, Vec3 position) {
    Underneath.Place place = underneath.of(arena, position);
    Shadow cast = Shadow.at(position.z() - place.height());
    Pose below = new Pose(position.withZ(place.height()), Attitude.LEVEL);
    return new Placed(Shared.SHADOW, below, place.radius(), cast.opacity());
  }

  private static Pose onFloor(Pose pose) {
    return new Pose(pose.position().withZ(0), pose.attitude());
  }

  /** A ring with an arrow upwards and an H, as on a landing place. */
  private static Sketch startMark() {
    Point middle = new Point(128, 152);
    return new Sketch(START_PICTURE)
        .stroke(Arc.circle(middle, 88).points(), 12)
        .stroke(Arc.circle(middle, 66).points(), 5)
        .fill(List.of(new Point(128, 4), new Point(168, 54), new Point(88, 54)))
        .stroke(List.of(new Point(104, 126), new Point(104, 178)), 14)
        .stroke(List.of(new Point(152, 126), new Point(152, 178)), 14)
        .stroke(List.of(new Point(104, 152), new Point(152, 152)), 14);
  }

  /** A soft round spot. */
  private static Texture shadowSpot() {
    int[] pixels = new int[SHADOW_PICTURE * SHADOW_PICTURE];
    Arrays.setAll(pixels, GroundMark::shadowPixel);
    return new Texture(SHADOW_PICTURE, SHADOW_PICTURE, pixels);
  }

  private static int shadowPixel(int pixel) {
    double half = SHADOW_PICTURE / 2.0;
    int row = pixel / SHADOW_PICTURE;
    double x = (pixel - row * SHADOW_PICTURE + 0.5) / half - 1;
    double y = (row + 0.5) / half - 1;
    double part = Math.max(0, 1 - x * x - y * y);
    return Rgb.BLACK.argb(part * part);
  }
}
