package tellosimulator.scenery.room;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Texture;
import tellosimulator.scenery.room.Face.Area;
import tellosimulator.scenery.room.Quads.Patch;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;

/** The posters in a room. For one thread at a time. */
final class Gallery {

  private final PictureShelf pictures = new PictureShelf();

  /** The posters as parts of a room, room frame, in the order in which they are drawn. */
  List<Part> parts(Room room, List<Poster> posters) {
    List<Part> parts = new ArrayList<>();
    for (Poster poster : posters) {
      Picture picture = pictures.of(poster.picture());
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
}
