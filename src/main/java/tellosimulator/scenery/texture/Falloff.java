package tellosimulator.scenery.texture;

import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/** A shade that is darkest at the lower edge of a texture and fades out towards the upper edge. */
public final class Falloff {

  private static final int WIDTH = 4;
  private static final int HEIGHT = 64;

  /**
   * The region from the centre of the first texel to the centre of the last one, so that the edges
   * do not wrap around.
   */
  public static final TextureRegion REGION =
      new TextureRegion(0, 0.5 / HEIGHT, 1, 1 - 1.0 / HEIGHT);

  private Falloff() {}

  /**
   * Returns the intensity of the shade, 0 to 1.
   *
   * @param near 1 at the edge, 0 at the end of the shade; negative beyond that
   */
  public static double at(double near) {
    double part = Math.max(0, near);
    return part * part * (0.6 + 0.4 * part);
  }

  /**
   * Returns a texture of the shade. Use it with {@link #REGION}.
   *
   * @param darkest opacity at the lower edge, 0 to 1
   */
  public static Texture texture(Rgb color, double darkest) {
    int[] argb = new int[WIDTH * HEIGHT];
    for (int i = 0; i < argb.length; i++) {
      int row = i / WIDTH;
      double near = row / (HEIGHT - 1.0);
      argb[i] = color.argb(darkest * at(near));
    }
    return new Texture(WIDTH, HEIGHT, argb);
  }
}
