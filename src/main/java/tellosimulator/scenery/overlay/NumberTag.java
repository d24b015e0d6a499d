package tellosimulator.scenery.overlay;

import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.AlphaMask;
import tellosimulator.scenery.texture.AlphaMask.Point;
import tellosimulator.scenery.texture.Canvas;
import tellosimulator.scenery.texture.StrokeFont;

/**
 * A drone's number above it: a billboard that is equally large from near and far. Immutable; for
 * any thread.
 */
final class NumberTag {

  /** Height above the drone's feet [m]. Decided: clear of the propellers. */
  private static final double HEIGHT = 0.07;

  /** Its size, as a share of the distance from the camera. Decided: by eye. */
  private static final double SIZE = 0.032;

  /** Edge of the texture [texels]. */
  private static final int TEXELS = 64;

  private static final Point CENTER = new Point(32, 32);

  /** 1 wide and 1 high in the camera's frame, standing on the origin, seen from behind. */
  private static final Mesh MESH =
      MeshBuilder.of(new Quad(new Vec3(0, 0.5, 0), new Vec3(0, -1, 0), Vec3.UP));

  private final Part part;

  NumberTag(int number, Livery livery) {
    part = new Part(MESH, texture(Integer.toString(number), livery), Shading.TRANSLUCENT);
  }

  /**
   * The tag at its place.
   *
   * @param drone its position, room frame [m]
   */
  Instance above(Vec3 drone, Pose camera) {
    Vec3 position = drone.plusScaled(Vec3.UP, HEIGHT);
    double size = SIZE * camera.position().distanceTo(position);
    return new Instance(part, new Pose(position, camera.attitude()), size, 1);
  }

  /** White digits on a disc of the drone's colour, with a white rim. */
  private static Texture texture(String digits, Livery livery) {
    double height = digits.length() == 1 ? 32 : 24;
    double advance = 0.65 * height;
    double left = CENTER.x() - advance * (digits.length() - 1) / 2;
    return new Canvas(TEXELS, Rgb.WHITE)
        .paint(livery.color(), mask -> mask.dot(CENTER, 28))
        .paint(
            Rgb.WHITE,
            mask -> {
              for (int i = 0; i < digits.length(); i++) {
                Point center = new Point(left + i * advance, CENTER.y());
                StrokeFont.draw(mask, digits.charAt(i), center, height);
              }
            })
        .cutOut(new AlphaMask(TEXELS).dot(CENTER, 31));
  }
}
