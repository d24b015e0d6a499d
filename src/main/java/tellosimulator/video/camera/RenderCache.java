package tellosimulator.video.camera;

import java.util.Map;
import java.util.WeakHashMap;
import java.util.function.Function;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Texture;

/**
 * A cache of meshes and textures that have been prepared for rendering in a colour space. They are
 * prepared when first rendered, and are kept as long as a scene refers to the originals.
 * Thread-safe; shared by all cameras.
 */
public final class RenderCache {

  private static final int OPAQUE = 0xff000000;

  private final ColorSpace space;
  private final WeakCache<Mesh, RenderMesh> meshes = new WeakCache<>(RenderMesh::new);
  private final WeakCache<Texture, MipMap> opaque;
  private final WeakCache<Texture, MipMap> translucent;

  public RenderCache(ColorSpace space) {
    this.space = space;
    opaque = new WeakCache<>(texture -> new MipMap(texture, space, false));
    translucent = new WeakCache<>(texture -> new MipMap(texture, space, true));
  }

  ColorSpace space() {
    return space;
  }

  RenderMesh mesh(Part part) {
    return meshes.get(part.mesh());
  }

  MipMap texture(Part part) {
    return (part.material().shading().blended() ? translucent : opaque)
        .get(part.material().texture());
  }

  /**
   * Returns the opaque colour of a part's texture at texture coordinates, packed in the colour
   * space. The coordinates wrap around.
   *
   * @param u distance from the left edge, in widths of the texture
   * @param v distance from the upper edge, in heights of the texture
   */
  int color(Part part, float u, float v) {
    Texture texture = part.material().texture();
    int x = Math.floorMod((int) Math.floor(u * texture.width()), texture.width());
    int y = Math.floorMod((int) Math.floor(v * texture.height()), texture.height());
    return space.pack(texture.argb(x, y) | OPAQUE);
  }

  /** The number of cached textures. */
  int textures() {
    return opaque.size() + translucent.size();
  }

  /**
   * Stores values that are computed from keys. A value is kept as long as its key is reachable, and
   * must not refer to its key. Thread-safe; a value that two threads request at the same time is
   * computed once.
   *
   * @param <K> the type of the keys, which are compared by identity
   */
  private static final class WeakCache<K, V> {

    private final Map<K, V> values = new WeakHashMap<>();
    private final Function<K, V> compute;

    WeakCache(Function<K, V> compute) {
      this.compute = compute;
    }

    synchronized V get(K key) {
      V value = values.get(key);
      if (value == null) {
        value = compute.apply(key);
        values.put(key, value);
      }
      return value;
    }

    synchronized int size() {
      return values.size();
    }
  }
}
