package tellosimulator.scenery.overlay;

import java.util.EnumMap;
import java.util.Map;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.overlay.Marker.Layer;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;
import tellosimulator.scenery.texture.StrokeFont;

/**
 * The number of a drone, above it and its ring. That of the chosen one of several drones is larger
 * and in front of all others; of many, the others are smaller. Immutable; for any thread.
 */
final class DroneTag {

  /** Height above the drone's feet [m]. Decided: clear of the propellers. */
  private static final double HEIGHT = 0.07;

  /** Its size, as a share of the distance from the camera. Decided: by eye. */
  static final double SIZE = 0.032;

  /** How much larger the tag of a chosen drone is. Decided: to be found among twenty. */
  private static final double LARGER = 1.3;

  /** How much smaller those of many others are. Decided: tags of twenty drones hardly overlap. */
  private static final double SMALLER = 0.7;

  /** More than so many drones are many. Decided: the tags of eight stand side by side. */
  private static final int MANY = 8;

  /** Edge of the texture [texels]. */
  private static final int TEXELS = 64;

  private static final Point CENTER = new Point(32, 32);

  private final Map<Emphasis, Billboard> billboards = new EnumMap<>(Emphasis.class);

  /**
   * @param drones how many there are
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
   * The tag at its place, in front of everything.
   *
   * @param drone room frame
   * @param clear how much higher than the drone it is seen [m]
   */
  Marker above(Pose drone, double clear, Emphasis emphasis, Eye eye) {
    Pose camera = eye.pose();
    Vec3 up = camera.attitude().toRoom(Vec3.UP);
    Vec3 place = drone.position().plusScaled(Vec3.UP, HEIGHT).plusScaled(up, clear);
    double distance = camera.position().distanceTo(drone.position());
    double order = emphasis == Emphasis.STRONG ? 0 : distance;
    double near = Layer.DRONE_TAGS.distance(order, eye);
    Instance tag = billboards.get(emphasis).inFront(place, camera, 0, near);
    return Marker.inFront(Layer.DRONE_TAGS, tag, order);
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
