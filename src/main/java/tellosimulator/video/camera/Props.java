package tellosimulator.video.camera;

import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Texture;

/**
 * Meshes and textures made ready for drawing in a colour space: made when a camera first sees them,
 * and kept as long as a scene has them. For any thread; all cameras share one.
 */
public final class Props {

  private static final int OPAQUE = 0xff000000;

  private final ColorSpace space;
  private final WeakCache<Mesh, Shape> shapes = new WeakCache<>(Shape::new);
  private final WeakCache<Texture, MipMaps> opaque;
  private final WeakCache<Texture, MipMaps> masked;

  public Props(ColorSpace space) {
    this.space = space;
    opaque = new WeakCache<>(texture -> new MipMaps(texture, space, false));
    masked = new WeakCache<>(texture -> new MipMaps(texture, space, true));
  }

  ColorSpace space() {
    return space;
  }

  Shape shape(Part part) {
    return shapes.get(part.mesh());
  }

  MipMaps texture(Part part) {
    return (part.finish() == Finish.DECAL || part.finish() == Finish.SHEER ? masked : opaque)
        .get(part.texture());
  }

  /**
   * The opaque colour at a place of a part's texture, which repeats, as a packed pixel of the
   * colour space.
   *
   * @param u from the left edge, in widths of the texture
   * @param v from the upper edge, in its heights
   */
  int color(Part part, float u, float v) {
    Texture texture = part.texture();
    int x = Math.floorMod((int) Math.floor(u * texture.width()), texture.width());
    int y = Math.floorMod((int) Math.floor(v * texture.height()), texture.height());
    return space.of(texture.argb(x, y) | OPAQUE);
  }

  /** How many textures are kept. */
  int textures() {
    return opaque.size() + masked.size();
  }
}
