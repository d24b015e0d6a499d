package tellosimulator.scenery.overlay;

import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.overlay.Marker.Layer;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;
import tellosimulator.scenery.texture.StrokeFont;

/** The number of a drone, above it and its ring. Immutable; for any thread. */
final class DroneTag {

  /** Height above the drone's feet [m]. Decided: clear of the propellers. */
  private static final double HEIGHT = 0.07;

  /** Its size, as a share of the distance from the camera. Decided: by eye. */
  static final double SIZE = 0.032;

  /** Edge of the texture [texels]. */
  private static final int TEXELS = 64;

  private static final Point CENTER = new Point(32, 32);

  private final Billboard billboard;

  DroneTag(int number, Livery livery) {
    billboard = Billboard.standing(texture(number, livery), SIZE);
  }

  /**
   * The tag at its place, in front of everything.
   *
   * @param drone room frame
   * @param clear how much higher than the drone it is seen [m]
   */
  Marker above(Pose drone, double clear, Eye eye) {
    Pose camera = eye.pose();
    Vec3 up = camera.attitude().toRoom(Vec3.UP);
    Vec3 place = drone.position().plusScaled(Vec3.UP, HEIGHT).plusScaled(up, clear);
    double distance = camera.position().distanceTo(drone.position());
    double near = Layer.DRONE_TAGS.distance(distance, eye);
    return Marker.inFront(Layer.DRONE_TAGS, billboard.inFront(place, camera, 0, near), distance);
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
