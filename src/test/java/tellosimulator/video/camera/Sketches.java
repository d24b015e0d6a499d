package tellosimulator.video.camera;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.Texture;

/** Simple things to look at. */
final class Sketches {

  static final int WHITE = 0xffffffff;
  static final int BLACK = 0xff000000;
  static final int RED = 0xffff0000;
  static final int GREEN = 0xff00ff00;
  static final int BLUE = 0xff0000ff;

  static final Pose ORIGIN = new Pose(Vec3.ZERO, Attitude.LEVEL);

  private static final float SQUARE = 1;

  private Sketches() {}

  /** A parallelogram and how often the picture is repeated on it. */
  record Sheet(Vec3 corner, Vec3 right, Vec3 up, double across, double down) {
    Sheet(Vec3 corner, Vec3 right, Vec3 up) {
      this(corner, right, up, 1, 1);
    }

    /** Upright at a distance ahead, facing an eye at the origin that looks along x. */
    static Sheet ahead(double distance, Vec3 middle, double size) {
      return new Sheet(
          new Vec3(distance, middle.y() + size / 2, middle.z() - size / 2),
          new Vec3(0, -size, 0),
          new Vec3(0, 0, size));
    }
  }

  /** Seen from where right is to the right and up is up. */
  static Mesh mesh(Sheet... sheets) {
    float[] points = new float[12 * sheets.length];
    float[] normals = new float[3 * sheets.length];
    float[] places = new float[8 * sheets.length];
    int[] corners = new int[18 * sheets.length];
    for (int i = 0; i < sheets.length; i++) {
      Sheet sheet = sheets[i];
      put(points, 12 * i, sheet.corner);
      put(points, 12 * i + 3, sheet.corner.plus(sheet.right));
      put(points, 12 * i + 6, sheet.corner.plus(sheet.right).plus(sheet.up));
      put(points, 12 * i + 9, sheet.corner.plus(sheet.up));
      put(normals, 3 * i, sheet.right.cross(sheet.up).normalized());
      float u = (float) sheet.across;
      float v = (float) sheet.down;
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

  /** Squares of two colours. */
  static Texture chessboard(int squares, int size) {
    int[] argb = new int[size * size];
    for (int i = 0; i < argb.length; i++) {
      int sum = i % size * squares / size + i / size * squares / size;
      argb[i] = sum % 2 == 0 ? 0xffe0d8c8 : 0xff405068;
    }
    return new Texture(size, size, argb);
  }

  /** Detail everywhere, the same with each run. */
  static Texture noise(int size, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int[] argb = new int[size * size];
    for (int i = 0; i < argb.length; i++) {
      int grey = 40 + random.nextInt(200);
      argb[i] = BLACK | grey << 16 | (grey * 7 / 8) << 8 | grey * 3 / 4;
    }
    return new Texture(size, size, argb);
  }

  static Placed painted(Texture texture, Sheet... sheets) {
    return new Placed(new Part(mesh(sheets), texture, Finish.PAINTED), ORIGIN);
  }

  static Scene scene(Placed... parts) {
    return new Scene(List.of(parts));
  }

  /** A room of 6 by 5 by 3 metres, its middle on the floor at the origin. */
  static List<Placed> room() {
    Vec3 x = new Vec3(6, 0, 0);
    Vec3 y = new Vec3(0, 5, 0);
    Vec3 z = new Vec3(0, 0, 3);
    Vec3 corner = new Vec3(-3, -2.5, 0);
    Texture wall = noise(512, 1);
    List<Placed> parts = new ArrayList<>();
    parts.add(
        painted(
            chessboard(2, 512), new Sheet(corner.plus(x), y, x.times(-1), 5 * SQUARE, 6 * SQUARE)));
    parts.add(painted(noise(256, 3), new Sheet(corner.plus(z), y, x, 5, 6)));
    parts.add(painted(wall, new Sheet(corner.plus(x).plus(y), y.times(-1), z, 2.5, 1.5)));
    parts.add(painted(chessboard(16, 1024), new Sheet(corner, y, z, 2.5, 1.5)));
    parts.add(painted(noise(1024, 2), new Sheet(corner.plus(y), x, z, 3, 1.5)));
    parts.add(painted(chessboard(8, 256), new Sheet(corner.plus(x), x.times(-1), z, 3, 1.5)));
    return parts;
  }

  private static void put(float[] to, int at, Vec3 vector) {
    to[at] = (float) vector.x();
    to[at + 1] = (float) vector.y();
    to[at + 2] = (float) vector.z();
  }
}
