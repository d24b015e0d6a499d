package tellosimulator.scenery.paint;

import java.util.Arrays;
import java.util.function.Consumer;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;

/** Drawings in several inks on a square sheet of paper, the later ones over the earlier ones. */
public final class Print {

  private final int size;
  private final int[] pixels;

  /**
   * Paper with nothing on it.
   *
   * @param size edge of the sheet [pixels]
   */
  public Print(int size, Rgb paper) {
    this.size = size;
    pixels = new int[size * size];
    Arrays.fill(pixels, paper.argb());
  }

  /**
   * Prints in an ink.
   *
   * @param drawing draws on an empty sheet
   */
  public Print ink(Rgb color, Consumer<Sketch> drawing) {
    Sketch sketch = new Sketch(size);
    drawing.accept(sketch);
    sketch.print(color, pixels);
    return this;
  }

  /** What the sheet looks like now, row by row. */
  public int[] pixels() {
    return pixels.clone();
  }

  /** What the sheet looks like now. */
  public Texture texture() {
    return new Texture(size, size, pixels);
  }
}
