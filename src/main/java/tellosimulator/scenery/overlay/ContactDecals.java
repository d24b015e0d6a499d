package tellosimulator.scenery.overlay;

import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.overlay.OverlayItem.Layer;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;

/**
 * The markers of contacts. A red pin with a cross marks the place where a drone touched something.
 * A larger red diamond with a cross marks the place where a drone crashed. The tip of each marker
 * is at the place of contact. The markers are drawn in front of the room, and in front of the rings
 * around drones. Not thread-safe.
 */
final class ContactDecals {

  /**
   * Size of the marker of a touch, as a fraction of the distance from the camera. Decided: by eye.
   */
  private static final double TOUCH = 0.03;

  /**
   * Size of the marker of a crash, as a fraction of the distance from the camera. Decided: by eye.
   */
  private static final double CRASH = 0.042;

  /**
   * Height of a marker's tip above the drone's feet [m]. Documented: half of the drone's height of
   * 41 mm.
   */
  private static final double MIDDLE = 0.02;

  /** Side length of the textures [texels]. */
  private static final int TEXELS = 64;

  private static final Point CENTER = new Point(32, 32);

  /** Centre of the disc of a pin. */
  private static final Point PIN_HEAD = new Point(32, 24);

  private final Billboard touch = Billboard.standing(touchTexture(), TOUCH);
  private final Billboard crash = Billboard.standing(crashTexture(), CRASH);

  OverlayItem of(ContactDecal mark, Eye eye) {
    Vec3 place = mark.place().plusScaled(Vec3.UP, MIDDLE);
    double distance = eye.pose().position().distanceTo(place);
    double near = Layer.CONTACTS.distance(distance, eye);
    Billboard billboard = mark.crash() ? crash : touch;
    return OverlayItem.inFront(
        Layer.CONTACTS, billboard.inFront(place, eye.pose(), 0, near), distance);
  }

  private static Texture touchTexture() {
    return new Canvas(TEXELS, Rgb.WHITE)
        .paint(OverlayColors.CONTACT, mask -> pin(mask, 19, 58))
        .paint(Rgb.WHITE, mask -> cross(mask, PIN_HEAD, 8))
        .cutOut(pin(new AlphaMask(TEXELS), 23, 63));
  }

  private static Texture crashTexture() {
    return new Canvas(TEXELS, Rgb.WHITE)
        .paint(OverlayColors.CONTACT, mask -> mask.fill(diamond(26)))
        .paint(Rgb.WHITE, mask -> cross(mask, CENTER, 8))
        .cutOut(new AlphaMask(TEXELS).fill(diamond(31)));
  }

  /**
   * Draws a disc with a tip below it.
   *
   * @param radius radius of the disc
   * @param tip distance of the tip from the top of the texture
   */
  private static AlphaMask pin(AlphaMask mask, double radius, double tip) {
    Point left = new Point(PIN_HEAD.x() - 0.7 * radius, PIN_HEAD.y() + 0.7 * radius);
    Point right = new Point(PIN_HEAD.x() + 0.7 * radius, PIN_HEAD.y() + 0.7 * radius);
    return mask.dot(PIN_HEAD, radius).fill(List.of(left, right, new Point(PIN_HEAD.x(), tip)));
  }

  private static void cross(AlphaMask mask, Point middle, double reach) {
    for (int side : new int[] {1, -1}) {
      Point from = new Point(middle.x() - reach, middle.y() - side * reach);
      Point to = new Point(middle.x() + reach, middle.y() + side * reach);
      mask.stroke(List.of(from, to), 7);
    }
  }

  private static List<Point> diamond(double reach) {
    return List.of(at(0, -reach), at(reach, 0), at(0, reach), at(-reach, 0));
  }

  private static Point at(double right, double down) {
    return new Point(CENTER.x() + right, CENTER.y() + down);
  }
}
