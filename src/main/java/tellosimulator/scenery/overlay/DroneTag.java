package tellosimulator.scenery.overlay;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;
import tellosimulator.scenery.texture.StrokeFont;

/**
 * What shows people where a drone is: its number above it or, where there is one alone, an
 * arrowhead that points down at it from afar. Immutable; for any thread.
 */
final class DroneTag {

  /** Height above the drone's feet [m]. Decided: clear of the propellers. */
  private static final double HEIGHT = 0.07;

  /** Its size, as a share of the distance from the camera. Decided: by eye. */
  static final double SIZE = 0.032;

  /** Edge of the texture [texels]. */
  private static final int TEXELS = 64;

  private static final Point CENTER = new Point(32, 32);

  /** Size of an arrowhead, as a share of the distance from the camera. Decided: by eye. */
  private static final double ARROWHEAD_SIZE = 0.024;

  /** Nearer than this a drone needs no arrowhead [m]. Decided: it is 40 pixels wide there. */
  private static final double ARROWHEAD_DISTANCE = 2.5;

  private final Billboard billboard;
  private final double nearest;

  private DroneTag(Billboard billboard, double nearest) {
    this.billboard = billboard;
    this.nearest = nearest;
  }

  /** A number, seen from everywhere. */
  static DroneTag number(int number, Livery livery) {
    return new DroneTag(Billboard.standing(texture(number, livery), SIZE), 0);
  }

  /** An arrowhead, seen from afar. */
  static DroneTag arrowhead(Livery livery) {
    Texture texture =
        new Canvas(TEXELS, Rgb.WHITE)
            .paint(livery.color(), mask -> mask.fill(triangle(22)))
            .cutOut(new AlphaMask(TEXELS).fill(triangle(31)));
    return new DroneTag(Billboard.standing(texture, ARROWHEAD_SIZE), ARROWHEAD_DISTANCE);
  }

  /**
   * The tag at its place; empty if it is not needed.
   *
   * @param drone its position, room frame [m]
   */
  Optional<Instance> above(Vec3 drone, Pose camera) {
    return camera.position().distanceTo(drone) < nearest
        ? Optional.empty()
        : Optional.of(billboard.at(drone.plusScaled(Vec3.UP, HEIGHT), camera));
  }

  /** One that stands on its tip. */
  private static List<Point> triangle(double size) {
    return List.of(
        new Point(CENTER.x() - size, CENTER.y() - 0.85 * size),
        new Point(CENTER.x() + size, CENTER.y() - 0.85 * size),
        new Point(CENTER.x(), CENTER.y() + size));
  }

  /** White digits on a disc of the drone's colour, with a white rim. */
  private static Texture texture(int number, Livery livery) {
    return new Canvas(TEXELS, Rgb.WHITE)
        .paint(livery.color(), mask -> mask.dot(CENTER, 28))
        .paint(Rgb.WHITE, mask -> write(mask, number))
        .cutOut(new AlphaMask(TEXELS).dot(CENTER, 31));
  }

  /** Draws a number in the middle of a mask of 64 pixels. */
  static void write(AlphaMask mask, int number) {
    String digits = Integer.toString(number);
    double height = digits.length() == 1 ? 32 : 24;
    double advance = 0.65 * height;
    double left = CENTER.x() - advance * (digits.length() - 1) / 2;
    for (int i = 0; i < digits.length(); i++) {
      Point center = new Point(left + i * advance, CENTER.y());
      StrokeFont.draw(mask, digits.charAt(i), center, height);
    }
  }
}
