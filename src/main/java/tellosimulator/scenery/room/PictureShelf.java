package tellosimulator.scenery.room;

import java.io.IOException;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.paint.Tile;

/**
 * Image files, each read once. Instead of one that cannot be read, which the log says, there is a
 * grey board. For any thread.
 */
public final class PictureShelf {

  private static final int BLANK_SIZE = 256;

  private final Map<String, Picture> pictures = new ConcurrentHashMap<>();

  /** The picture in a file. */
  public Picture of(String file) {
    return pictures.computeIfAbsent(file, PictureShelf::read);
  }

  private static Picture read(String file) {
    try {
      return PictureFile.read(file);
    } catch (IOException e) {
      log().warn("A picture stays blank: {}.", e.getMessage());
      int grey = Rgb.of(0x9a9a9a).argb();
      return new Picture(Tile.painted(BLANK_SIZE, () -> (x, y) -> grey), 1);
    }
  }

  /** Not a constant: logging takes long to start, and the first picture does not wait for it. */
  private static Logger log() {
    return LoggerFactory.getLogger(PictureShelf.class);
  }
}
