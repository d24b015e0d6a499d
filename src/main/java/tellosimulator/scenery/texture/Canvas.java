package tellosimulator.scenery.texture;

import java.util.Arrays;
import java.util.function.Consumer;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/** A square image that is painted in several colours, one over the other. For one thread. */
public final class Canvas {

  private final int size;
  private final int[] pixels;

  /**
   * A canvas of one colour.
   *
   * @param size its edge [pixels]
   */
  public Canvas(int size, Rgb background) {
    this.size = size;
    pixels = new int[size * size];
    Arrays.fill(pixels, background.argb());
  }

  /**
   * Paints a colour where a mask covers the canvas.
   *
   * @param drawing draws on an empty mask
   */
  public Canvas paint(Rgb color, Consumer<AlphaMask> drawing) {
    AlphaMask mask = new AlphaMask(size);
    drawing.accept(mask);
    mask.paint(color, pixels);
    return this;
  }

  /** A copy of the opaque image, row by row. */
  public int[] argb() {
    return pixels.clone();
  }

  /** The part of the image that a mask covers; the rest is transparent. */
  public Texture cutOut(AlphaMask mask) {
    return new Texture(size, size, mask.applyTo(pixels));
  }
}
