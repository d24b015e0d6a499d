package tellosimulator.scenery.overlay;

import java.util.EnumMap;
import java.util.Map;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.overlay.OverlayItem.Layer;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;
import tellosimulator.scenery.texture.StrokeFont;

/**
 * The number of a drone, shown above the drone and its ring. The tag of a selected drone is larger
 * and in front of all others. If there are many drones, the other tags are smaller. Immutable.
 */
final class DroneTag {

  /** Height above the drone's feet [m]. Decided: clear of the propellers. */
  private static final double HEIGHT = 0.07;

  /** Size of a tag, as a fraction of the distance from the camera. Decided: by eye. */
  static final double SIZE = 0.032;

  /** Scale of a selected drone's tag. Decided: the tag is easy to find among twenty tags. */
  private static final double LARGER = 1.3;

  /**
   * Scale of the other tags if there are many drones. Decided: the tags of twenty drones hardly
   * overlap.
   */
  private static final double SMALLER = 0.7;

  /**
   * Number of drones above which {@link #SMALLER} applies. Decided: up to eight tags fit side by
   * side.
   */
  private static final int MANY = 8;

  /** Side length of the texture [texels]. */
  private static final int TEXELS = 64;

  private static final Point CENTER = new Point(32, 32);

  private final Map<Emphasis, Billboard> billboards = new EnumMap<>(Emphasis.class);

  /**
   * Creates the tag of a drone.
   *
   * @param drones total number of drones
   */
  DroneTag(int number, Livery livery, int drones) {
    Texture texture = texture(number, livery);
    for (Emphasis emphasis : Emphasis.values()) {
      billboards.put(emphasis, Billboard.standing(texture, SIZE * factor(emphasis, drones)));
    }
  }

  private static double factor(Emphasis emphasis, int drones) {
    return switch (emphasis) {
      case NORMAL -> 1;
      case STRONG -> LARGER;
      case FAINT -> drones > MANY ? SMALLER : 1;
    };
  }

  /**
   * Returns the tag above a drone, drawn in front of everything else.
   *
   * @param drone pose of the drone in the room frame
   * @param clear distance above the drone, upwards on the screen, that the tag must leave free [m]
   */
  OverlayItem above(Pose drone, double clear, Emphasis emphasis, Eye eye) {
    Pose camera = eye.pose();
    Vec3 up = camera.attitude().toRoom(Vec3.UP);
    Vec3 place = drone.position().plusScaled(Vec3.UP, HEIGHT).plusScaled(up, clear);
    double distance = camera.position().distanceTo(drone.position());
    double order = emphasis == Emphasis.STRONG ? 0 : distance;
    double near = Layer.DRONE_TAGS.distance(order, eye);
    Instance tag = billboards.get(emphasis).inFront(place, camera, 0, near);
    return OverlayItem.inFront(Layer.DRONE_TAGS, tag, order);
  }

  /** Returns a texture with white digits on a disc that has the drone's colour and a white rim. */
  private static Texture texture(int number, Livery livery) {
    return new Canvas(TEXELS, Rgb.WHITE)
        .paint(livery.color(), mask -> mask.dot(CENTER, 28))
        .paint(Rgb.WHITE, mask -> write(mask, number))
        .cutOut(new AlphaMask(TEXELS).dot(CENTER, 31));
  }

  /** Draws a number in the middle of a mask of 64 × 64 pixels. */
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
