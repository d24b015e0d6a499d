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

  /** How many textures are kept. */
  int textures() {
    return opaque.size() + masked.size();
  }
}
