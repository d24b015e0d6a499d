package tellosimulator.scenery.room;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.room.Face.Area;
import tellosimulator.scenery.texture.ImageCache;
import tellosimulator.scenery.texture.ImageTexture;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;

/** Creates the posters in a room. Not thread-safe. */
final class Posters {

  private final ImageCache images = new ImageCache();

  /** Returns the posters as parts in drawing order, in the room frame. */
  List<Part> parts(Room room, List<Poster> posters) {
    List<Part> parts = new ArrayList<>();
    for (Poster poster : posters) {
      ImageTexture image = images.get(poster.picture());
      Face face = Face.of(room, poster.surface());
      Area whole = area(poster, image);
      Area seen = whole.within(face.area());
      if (seen.width() > 0 && seen.height() > 0) {
        TextureRegion region = region(whole, seen, image.texture());
        Mesh mesh = new MeshBuilder().quad(face.quad(seen), region).build();
        parts.add(new Part(mesh, image.texture(), Shading.DECAL));
      }
    }
    return parts;
  }

  private static Area area(Poster poster, ImageTexture image) {
    double height = poster.width() * image.aspectRatio();
    return new Area(
        poster.along() - poster.width() / 2, poster.height() - height / 2, poster.width(), height);
  }

  /**
   * Returns the texture region for the visible area of a poster. A whole poster reaches from the
   * centre of the first texel to the centre of the last one, so that its edges do not wrap around.
   */
  private static TextureRegion region(Area whole, Area seen, Texture texture) {
    double across = (1 - 1.0 / texture.width()) / whole.width();
    double down = (1 - 1.0 / texture.height()) / whole.height();
    return new TextureRegion(
        0.5 / texture.width() + (seen.left() - whole.left()) * across,
        0.5 / texture.height() + (whole.upper() - seen.upper()) * down,
        seen.width() * across,
        seen.height() * down);
  }
}
