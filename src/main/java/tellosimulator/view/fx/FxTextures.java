package tellosimulator.view.fx;

import java.util.Map;
import java.util.WeakHashMap;
import javafx.scene.image.Image;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/** The textures of a scenery as images, each converted once. For the JavaFX thread. */
public final class FxTextures {

  private final Map<Texture, Image> images = new WeakHashMap<>();

  /** The image of a texture. */
  public Image image(Texture texture) {
    return images.computeIfAbsent(texture, FxTextures::converted);
  }

  /** A colour. */
  public static Color color(Rgb color) {
    return Color.rgb(color.red(), color.green(), color.blue());
  }

  private static Image converted(Texture texture) {
    int width = texture.width();
    int height = texture.height();
    WritableImage image = new WritableImage(width, height);
    image
        .getPixelWriter()
        .setPixels(
            0, 0, width, height, PixelFormat.getIntArgbInstance(), texture.argbArray(), 0, width);
    return image;
  }
}
