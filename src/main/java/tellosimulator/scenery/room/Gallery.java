package tellosimulator.scenery.room;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.paint.Tile;
import tellosimulator.scenery.room.Face.Area;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;

/**
 * The posters in a room. Each file is read once; instead of one that cannot be read, which the log
 * says, hangs a grey board. For one thread at a time.
 */
final class Gallery {

  private static final int BLANK_SIZE = 256;

  private final Map<String, Picture> pictures = new HashMap<>();

  /** The posters as parts of a room, room frame, in the order in which they are drawn. */
  List<Part> parts(Room room, List<Poster> posters) {
    List<Part> parts = new ArrayList<>();
    for (Poster poster : posters) {
      Picture picture = pictures.computeIfAbsent(poster.picture(), Gallery::read);
      Face face = Face.of(room, poster.surface());
      Area whole = area(poster, picture);
      Area seen = whole.within(face.area());
      if (seen.width() > 0 && seen.height() > 0) {
        Quads quads = new Quads().add(face.part(seen), patch(whole, seen, picture.texture()));
        parts.add(new Part(quads.mesh(), picture.texture(), Finish.DECAL));
      }
    }
    return parts;
  }

  private static Area area(Poster poster, Picture picture) {
    double height = poster.width() * picture.ratio();
    return new Area(
        poster.along() - poster.width() / 2, poster.height() - height / 2, poster.width(), height);
  }

  /**
   * What is on a part of a poster. The whole goes from the middle of the first pixel to that of the
   * last, or its edges would repeat.
   */
  private static Patch patch(Area whole, Area seen, Texture texture) {
    double across = (1 - 1.0 / texture.width()) / whole.width();
    double down = (1 - 1.0 / texture.height()) / whole.height();
    return new Patch(
        0.5 / texture.width() + (seen.left() - whole.left()) * across,
        0.5 / texture.height() + (whole.upper() - seen.upper()) * down,
        seen.width() * across,
        seen.height() * down);
  }

  private static Picture read(String file) {
    try {
      return PictureFile.read(file);
    } catch (IOException e) {
      log().warn("A poster stays blank: {}.", e.getMessage());
      int grey = Rgb.of(0x9a9a9a).argb();
      return new Picture(Tile.painted(BLANK_SIZE, () -> (x, y) -> grey), 1);
    }
  }

  /** Not a constant: logging takes long to start, and the first picture does not wait for it. */
  private static Logger log() {
    return LoggerFactory.getLogger(Gallery.class);
  }
}
