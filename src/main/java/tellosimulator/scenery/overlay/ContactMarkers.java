package tellosimulator.scenery.overlay;

import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;

/**
 * The markers where drones touched something, a red disc with a cross, and where they crashed, a
 * larger red diamond with a cross. For one thread.
 */
final class ContactMarkers {

  /** Their sizes, as shares of the distance from the camera. Decided: by eye. */
  private static final double TOUCH = 0.018;

  private static final double CRASH = 0.03;

  /** Height above the drone's feet [m]. Documented: half of 41 mm. */
  private static final double MIDDLE = 0.02;

  /** Edge of the textures [texels]. */
  private static final int TEXELS = 64;

  private static final Point CENTER = new Point(32, 32);

  private final Billboard touch = Billboard.centered(touchTexture(), TOUCH);
  private final Billboard crash = Billboard.centered(crashTexture(), CRASH);

  Instance of(ContactMark mark, Pose camera) {
    Vec3 place = mark.place().plusScaled(Vec3.UP, MIDDLE);
    return (mark.crash() ? crash : touch).at(place, camera);
  }

  private static Texture touchTexture() {
    return new Canvas(TEXELS, Rgb.WHITE)
        .paint(MarkColors.CONTACT, mask -> mask.dot(CENTER, 27))
        .paint(Rgb.WHITE, mask -> cross(mask, 11))
        .cutOut(new AlphaMask(TEXELS).dot(CENTER, 31));
  }

  private static Texture crashTexture() {
    return new Canvas(TEXELS, Rgb.WHITE)
        .paint(MarkColors.CONTACT, mask -> mask.fill(diamond(26)))
        .paint(Rgb.WHITE, mask -> cross(mask, 8))
        .cutOut(new AlphaMask(TEXELS).fill(diamond(31)));
  }

  private static void cross(AlphaMask mask, double reach) {
    mask.stroke(List.of(at(-reach, -reach), at(reach, reach)), 7);
    mask.stroke(List.of(at(-reach, reach), at(reach, -reach)), 7);
  }

  private static List<Point> diamond(double reach) {
    return List.of(at(0, -reach), at(reach, 0), at(0, reach), at(-reach, 0));
  }

  private static Point at(double right, double down) {
    return new Point(CENTER.x() + right, CENTER.y() + down);
  }
}
