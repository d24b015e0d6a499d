package tellosimulator.scenery.texture;

import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/** A shade that is darkest at the lower edge of a texture and fades out towards the upper one. */
public final class Falloff {

  private static final int WIDTH = 4;
  private static final int HEIGHT = 64;

  /** From the centre of the first texel to that of the last, or the edges would wrap around. */
  public static final TextureRegion REGION =
      new TextureRegion(0, 0.5 / HEIGHT, 1, 1 - 1.0 / HEIGHT);

  private Falloff() {}

  /**
   * How much of the darkest shade there is.
   *
   * @param near 1 at the edge, 0 where the shade ends and beyond
   */
  public static double at(double near) {
    double part = Math.max(0, near);
    return part * part * (0.6 + 0.4 * part);
  }

  /**
   * A texture, to be used in {@link #REGION}.
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
