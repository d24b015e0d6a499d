package tellosimulator.view.drone;

import javafx.scene.image.Image;
import javafx.scene.image.PixelWriter;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import javafx.scene.shape.TriangleMesh;
import javafx.scene.shape.VertexFormat;

/**
 * What the eye sees of a propeller that turns fast: a translucent disc in which the blades are
 * smeared. About z, its middle at the origin [m].
 */
final class PropellerDisc {

  private static final int SIDES = 24;

  private static final int PICTURE_SIZE = 64;

  private static final Color BLADE = Color.web("#3b3e45");

  /** Opacity of the disc, and how much a smeared blade adds to it. Assumed: by eye. */
  private static final double DISC_OPACITY = 0.18;

  private static final double BLADE_OPACITY = 0.42;

  private PropellerDisc() {}

  static TriangleMesh create() {
    TriangleMesh mesh = new TriangleMesh(VertexFormat.POINT_NORMAL_TEXCOORD);
    mesh.getNormals().addAll(0, 0, 1);
    mesh.getPoints().addAll(0, 0, 0);
    mesh.getTexCoords().addAll(0.5f, 0.5f);
    for (int i = 0; i < SIDES; i++) {
      double angle = 2 * Math.PI * i / SIDES;
      float x = (float) Math.cos(angle);
      float y = (float) Math.sin(angle);
      float radius = (float) PropellerMesh.RADIUS;
      mesh.getPoints().addAll(radius * x, radius * y, 0);
      mesh.getTexCoords().addAll(0.5f + x / 2, 0.5f + y / 2);
      int next = (i + 1) % SIDES + 1;
      mesh.getFaces().addAll(0, 0, 0, i + 1, 0, i + 1, next, 0, next);
    }
    return mesh;
  }

  static Image picture() {
    WritableImage picture = new WritableImage(PICTURE_SIZE, PICTURE_SIZE);
    PixelWriter writer = picture.getPixelWriter();
    for (int i = 0; i < PICTURE_SIZE; i++) {
      for (int j = 0; j < PICTURE_SIZE; j++) {
        double x = (i + 0.5) * 2 / PICTURE_SIZE - 1;
        double y = (j + 0.5) * 2 / PICTURE_SIZE - 1;
        writer.setColor(
            i, j, Color.color(BLADE.getRed(), BLADE.getGreen(), BLADE.getBlue(), opacity(x, y)));
      }
    }
    return picture;
  }

  /**
   * How opaque the disc is.
   *
   * @param x along the blades, 1 at a tip
   * @param y across
   */
  static double opacity(double x, double y) {
    double radius = Math.hypot(x, y);
    double fromBlade = Math.atan2(Math.abs(y), Math.abs(x));
    double blade = Math.exp(-Math.pow(fromBlade / 0.5, 2));
    double tip = Math.max(0, Math.min(1, (1 - radius) * 12));
    return tip * (DISC_OPACITY + BLADE_OPACITY * blade * (1 - 0.45 * radius));
  }
}
