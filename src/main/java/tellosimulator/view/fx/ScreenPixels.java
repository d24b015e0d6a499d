package tellosimulator.view.fx;

import java.nio.IntBuffer;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/** A reusable pixel buffer that an ImageView shows. Confined to the JavaFX thread. */
public final class ScreenPixels {

  private final ImageView view;
  private Optional<PixelBuffer<IntBuffer>> pixels = Optional.empty();

  public ScreenPixels(ImageView view) {
    this.view = view;
  }

  /**
   * Shows new pixels.
   *
   * @param width the width of the picture [pixels]
   * @param height the height of the picture [pixels]
   * @param writer fills the pixels row by row, with 8 bits each for alpha, red, green and blue,
   *     premultiplied with alpha
   */
  public void show(int width, int height, Consumer<int[]> writer) {
    PixelBuffer<IntBuffer> target = pixels(width, height);
    writer.accept(target.getBuffer().array());
    target.updateBuffer(all -> null);
  }

  /** Removes the picture. */
  public void clear() {
    pixels = Optional.empty();
    view.setImage(null);
  }

  private PixelBuffer<IntBuffer> pixels(int width, int height) {
    Optional<PixelBuffer<IntBuffer>> before =
        pixels.filter(old -> old.getWidth() == width && old.getHeight() == height);
    if (before.isPresent()) {
      return before.get();
    }
    PixelBuffer<IntBuffer> made =
        new PixelBuffer<>(
            width, height, IntBuffer.allocate(width * height), PixelFormat.getIntArgbPreInstance());
    view.setImage(new WritableImage(made));
    pixels = Optional.of(made);
    return made;
  }
}
