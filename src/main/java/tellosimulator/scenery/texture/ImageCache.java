package tellosimulator.scenery.texture;

import java.io.IOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.scenery.mesh.Rgb;

/**
 * A cache that reads each image file only once. If a file cannot be read, a warning is logged, and
 * a plain grey texture is used instead. Thread-safe.
 */
public final class ImageCache {

  private static final Logger LOG = LoggerFactory.getLogger(ImageCache.class);

  private static final int BLANK_SIZE = 256;

  private final Map<String, ImageTexture> images = new ConcurrentHashMap<>();

  /** Returns the image in a file. */
  public ImageTexture get(String file) {
    return images.computeIfAbsent(file, ImageCache::read);
  }

  private static ImageTexture read(String file) {
    try {
      return ImageFile.read(file);
    } catch (IOException e) {
      LOG.warn("A picture stays blank: {}.", e.getMessage());
      int gray = Rgb.of(0x9a9a9a).argb();
      return new ImageTexture(ProceduralTexture.of(BLANK_SIZE, () -> (x, y) -> gray), 1);
    }
  }
}
