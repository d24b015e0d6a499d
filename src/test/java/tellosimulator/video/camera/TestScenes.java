package tellosimulator.video.camera;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;

/** Simple meshes, textures and scenes. */
final class TestScenes {

  static final int WHITE = 0xffffffff;
  static final int BLACK = 0xff000000;
  static final int RED = 0xffff0000;
  static final int GREEN = 0xff00ff00;
  static final int BLUE = 0xff0000ff;

  static final Pose ORIGIN = new Pose(Vec3.ZERO, Attitude.LEVEL);

  private static final float SQUARE = 1;

  private TestScenes() {}

  /** A parallelogram, and the number of repetitions of its texture. */
  record Quad(Vec3 corner, Vec3 right, Vec3 up, double across, double down) {
    Quad(Vec3 corner, Vec3 right, Vec3 up) {
      this(corner, right, up, 1, 1);
    }

    /** An upright square at a distance ahead, facing a camera at the origin that looks along x. */
    static Quad ahead(double distance, Vec3 middle, double size) {
      return new Quad(
          new Vec3(distance, middle.y() + size / 2, middle.z() - size / 2),
          new Vec3(0, -size, 0),
          new Vec3(0, 0, size));
    }
  }

  /** Creates a mesh whose front faces are seen with right to the right and up at the top. */
  static Mesh mesh(Quad... quads) {
    float[] points = new float[12 * quads.length];
    float[] normals = new float[3 * quads.length];
    float[] places = new float[8 * quads.length];
    int[] corners = new int[18 * quads.length];
    for (int i = 0; i < quads.length; i++) {
      Quad quad = quads[i];
      put(points, 12 * i, quad.corner);
      put(points, 12 * i + 3, quad.corner.plus(quad.right));
      put(points, 12 * i + 6, quad.corner.plus(quad.right).plus(quad.up));
      put(points, 12 * i + 9, quad.corner.plus(quad.up));
      put(normals, 3 * i, quad.right.cross(quad.up).normalized());
      float u = (float) quad.across;
      float v = (float) quad.down;
      float[] uv = {0, v, u, v, u, 0, 0, 0};
      System.arraycopy(uv, 0, places, 8 * i, 8);
      int[] order = {0, 1, 2, 0, 2, 3};
      for (int k = 0; k < 6; k++) {
        corners[18 * i + 3 * k] = 4 * i + order[k];
        corners[18 * i + 3 * k + 1] = i;
        corners[18 * i + 3 * k + 2] = 4 * i + order[k];
      }
    }
    return new Mesh(points, normals, places, corners);
  }

  static Texture plain(int argb) {
    return new Texture(1, 1, new int[] {argb});
  }

  /** A checkerboard of two colours. */
  static Texture checkerboard(int squares, int size) {
    int[] argb = new int[size * size];
    for (int i = 0; i < argb.length; i++) {
      int sum = i % size * squares / size + i / size * squares / size;
      argb[i] = sum % 2 == 0 ? 0xffe0d8c8 : 0xff405068;
    }
    return new Texture(size, size, argb);
  }

  /** A noise texture, the same in each run. */
  static Texture noise(int size, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int[] argb = new int[size * size];
    for (int i = 0; i < argb.length; i++) {
      int gray = 40 + random.nextInt(200);
      argb[i] = BLACK | gray << 16 | (gray * 7 / 8) << 8 | gray * 3 / 4;
    }
    return new Texture(size, size, argb);
  }

  static Instance painted(Texture texture, Quad... quads) {
    return new Instance(new Part(mesh(quads), texture, Shading.UNLIT), ORIGIN);
  }

  static Scene scene(Instance... parts) {
    return Scene.of(List.of(parts));
  }

  /** A room of 6 by 5 by 3 metres, its middle on the floor at the origin. */
  static List<Instance> room() {
    Vec3 x = new Vec3(6, 0, 0);
    Vec3 y = new Vec3(0, 5, 0);
    Vec3 z = new Vec3(0, 0, 3);
    Vec3 corner = new Vec3(-3, -2.5, 0);
    Texture wall = noise(512, 1);
    List<Instance> parts = new ArrayList<>();
    parts.add(
        painted(
            checkerboard(2, 512),
            new Quad(corner.plus(x), y, x.times(-1), 5 * SQUARE, 6 * SQUARE)));
    parts.add(painted(noise(256, 3), new Quad(corner.plus(z), y, x, 5, 6)));
    parts.add(painted(wall, new Quad(corner.plus(x).plus(y), y.times(-1), z, 2.5, 1.5)));
    parts.add(painted(checkerboard(16, 1024), new Quad(corner, y, z, 2.5, 1.5)));
    parts.add(painted(noise(1024, 2), new Quad(corner.plus(y), x, z, 3, 1.5)));
    parts.add(painted(checkerboard(8, 256), new Quad(corner.plus(x), x.times(-1), z, 3, 1.5)));
    return parts;
  }

  private static void put(float[] to, int at, Vec3 vector) {
    to[at] = (float) vector.x();
    to[at + 1] = (float) vector.y();
    to[at + 2] = (float) vector.z();
  }
}
