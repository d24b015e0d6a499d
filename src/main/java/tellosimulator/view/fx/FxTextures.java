package tellosimulator.view.fx;

import java.util.Map;
import java.util.WeakHashMap;
import javafx.scene.image.Image;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/**
 * Converts textures of a scene to JavaFX images, and caches the images. Confined to the JavaFX
 * thread.
 */
public final class FxTextures {

  private final Map<Texture, Image> images = new WeakHashMap<>();

  /** Returns the image of a texture. */
  public Image image(Texture texture) {
    return images.computeIfAbsent(texture, FxTextures::converted);
  }

  /** Converts a colour. */
  public static Color color(Rgb color) {
    return Color.rgb(color.red(), color.green(), color.blue());
  }

  private static Image converted(Texture texture) {
    return image(texture.width(), texture.height(), texture.argbArray());
  }

  /**
   * Returns an image with the given pixels.
   *
   * @param argb the pixels row by row, with 8 bits each for alpha, red, green and blue, not
   *     premultiplied
   */
  public static Image image(int width, int height, int[] argb) {
    WritableImage image = new WritableImage(width, height);
    image
        .getPixelWriter()
        .setPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), argb, 0, width);
    return image;
  }
}
