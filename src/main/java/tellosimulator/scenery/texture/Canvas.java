package tellosimulator.scenery.texture;

import java.util.Arrays;
import java.util.function.Consumer;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/** A square image onto which several colours are painted on top of each other. Not thread-safe. */
public final class Canvas {

  private final int size;
  private final int[] pixels;

  /**
   * Creates a canvas of one colour.
   *
   * @param size side length of the canvas [pixels]
   */
  public Canvas(int size, Rgb background) {
    this.size = size;
    pixels = new int[size * size];
    Arrays.fill(pixels, background.argb());
  }

  /**
   * Paints a colour where a mask covers the canvas.
   *
   * @param drawing draws on a mask that is initially empty
   */
  public Canvas paint(Rgb color, Consumer<AlphaMask> drawing) {
    AlphaMask mask = new AlphaMask(size);
    drawing.accept(mask);
    mask.paint(color, pixels);
    return this;
  }

  /** Returns a copy of the opaque image, row by row. */
  public int[] argb() {
    return pixels.clone();
  }

  /** Returns the part of the image that a mask covers. The rest is transparent. */
  public Texture cutOut(AlphaMask mask) {
    return new Texture(size, size, mask.applyTo(pixels));
  }
}
