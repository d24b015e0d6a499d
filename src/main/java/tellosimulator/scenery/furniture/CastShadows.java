package tellosimulator.scenery.furniture;

import java.util.Arrays;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Lights;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBatch;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.MeshBuilder.TextureRegion;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.PolygonClip;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.Room;

/**
 * The shadows that obstacles cast on the floor in the key light, so that one sees where a gate
 * stands and how high it is. They are baked into one texture when obstacles or room change, and
 * cost one decal in a picture. For any thread.
 */
public final class CastShadows {

  /** Edge of a texel at most, where it is possible [m]. Decided: less than a post is wide. */
  private static final double TEXEL = 0.025;

  private static final int LEAST_TEXELS = 128;

  /** Decided: more would take too long to bake while somebody moves an obstacle. */
  private static final int MOST_TEXELS = 1024;

  /**
   * Obstacles with more triangles cast no shadows. Decided: that is hundreds of gates, between
   * which one would not tell them apart, and a quarter of a second to bake.
   */
  private static final int MOST_TRIANGLES = 200_000;

  /** Opacity where no key light arrives. Decided: by eye. */
  private static final double DARKEST = 0.3;

  /**
   * Height of a layer, whose shadows are equally soft [m]; the last has no end. Decided: by eye.
   */
  private static final double LAYER = 0.6;

  private static final int LAYERS = 4;

  /** How far the shadow of an edge on the floor is blurred [m]. Decided: by eye. */
  private static final double LEAST_BLUR = 0.015;

  /** How much farther for each metre that the edge is above the floor. Decided: by eye. */
  private static final double BLUR_BY_HEIGHT = 0.03;

  private List<Instance> latest = List.of();
  private Room room = Room.DEFAULT;
  private List<Instance> instances = List.of();

  /**
   * The shadows in a room, room frame; the same list for the same obstacles.
   *
   * @param obstacles as they are drawn
   */
  public synchronized List<Instance> instances(Room newRoom, List<Instance> obstacles) {
    if (obstacles != latest || !newRoom.equals(room)) {
      latest = obstacles;
      room = newRoom;
      instances = make();
    }
    return instances;
  }

  private List<Instance> make() {
    List<Instance> opaque =
        latest.stream().filter(one -> !one.part().material().shading().blended()).toList();
    if (opaque.stream().mapToInt(one -> one.part().mesh().triangles()).sum() > MOST_TRIANGLES) {
      return List.of();
    }
    List<Mesh> meshes = MeshBatch.of(opaque).stream().map(Part::mesh).toList();
    FloorArea area = FloorArea.around(meshes, room);
    if (area.isEmpty()) {
      return List.of();
    }
    int size = area.texels();
    Texture texture = Texture.lazy(size, size, () -> texels(meshes, area));
    Mesh mesh = new MeshBuilder().quad(area.quad(), TextureRegion.unwrapped(size)).build();
    return List.of(Instance.atOrigin(new Part(mesh, texture, Shading.DECAL)));
  }

  /** Layer by layer: the higher it is, the softer its shadow. */
  private static int[] texels(List<Mesh> meshes, FloorArea area) {
    int size = area.texels();
    double[] shaded = new double[size * size];
    for (int i = 0; i < LAYERS; i++) {
      double bottom = i * LAYER;
      double top = i < LAYERS - 1 ? bottom + LAYER : Double.POSITIVE_INFINITY;
      ShadowLayer layer = new ShadowLayer(size);
      for (Mesh mesh : meshes) {
        fill(layer, mesh, bottom, top, area);
      }
      double blur = LEAST_BLUR + BLUR_BY_HEIGHT * (bottom + LAYER / 2);
      layer.blur(blur / area.texelWidth(), blur / area.texelHeight());
      layer.addTo(shaded);
    }
    int[] argb = new int[shaded.length];
    for (int i = 0; i < argb.length; i++) {
      argb[i] = Rgb.BLACK.argb(DARKEST * Math.min(1, shaded[i]));
    }
    return argb;
  }

  /** Fills the shadow of what of a mesh is between two heights [m]. */
  private static void fill(
      ShadowLayer layer, Mesh mesh, double bottom, double top, FloorArea area) {
    int[] faces = mesh.faceArray();
    for (int face = 0; face < faces.length; face += 9) {
      Vec3 a = mesh.position(faces[face]);
      Vec3 b = mesh.position(faces[face + 3]);
      Vec3 c = mesh.position(faces[face + 6]);
      double lowest = Math.min(a.z(), Math.min(b.z(), c.z()));
      double highest = Math.max(a.z(), Math.max(b.z(), c.z()));
      if (lowest < top && highest > bottom) {
        List<Vertex> lower = PolygonClip.clipped(triangle(a, b, c), Vec3.UP, top);
        List<Vertex> within = PolygonClip.clipped(lower, Vec3.UP.times(-1), -bottom);
        List<Vec3> shadow = within.stream().map(one -> Lights.onFloor(one.position())).toList();
        layer.fill(
            shadow.stream().mapToDouble(area::column).toArray(),
            shadow.stream().mapToDouble(area::row).toArray());
      }
    }
  }

  private static List<Vertex> triangle(Vec3... corners) {
    return Arrays.stream(corners).map(corner -> new Vertex(corner, Vec3.UP, 0, 0)).toList();
  }

  /**
   * The part of the floor that the texture covers, room frame [m]. The texture is seen from above,
   * x upwards, as on a plan.
   */
  private record FloorArea(double back, double front, double right, double left) {

    /** How far shadows may be blurred [m]. */
    private static final double MARGIN = 2 * (LEAST_BLUR + BLUR_BY_HEIGHT * LAYERS * LAYER);

    /** The smallest one with all shadows that are in the room. */
    static FloorArea around(List<Mesh> meshes, Room room) {
      double all = Double.POSITIVE_INFINITY;
      FloorArea around = new FloorArea(all, -all, all, -all);
      for (Mesh mesh : meshes) {
        for (int i = 0; i < mesh.positions(); i++) {
          around = around.with(Lights.onFloor(mesh.position(i)));
        }
      }
      return new FloorArea(
          Math.max(-room.depth() / 2, around.back - MARGIN),
          Math.min(room.depth() / 2, around.front + MARGIN),
          Math.max(-room.width() / 2, around.right - MARGIN),
          Math.min(room.width() / 2, around.left + MARGIN));
    }

    private FloorArea with(Vec3 point) {
      return new FloorArea(
          Math.min(back, point.x()),
          Math.max(front, point.x()),
          Math.min(right, point.y()),
          Math.max(left, point.y()));
    }

    boolean isEmpty() {
      return front <= back || left <= right;
    }

    Quad quad() {
      return new Quad(
          new Vec3(back, left, 0), new Vec3(0, right - left, 0), new Vec3(front - back, 0, 0));
    }

    /** Edge of the texture: as fine as it is worth while, a power of two. */
    int texels() {
      int texels = LEAST_TEXELS;
      while (texels < MOST_TEXELS && Math.max(front - back, left - right) > texels * TEXEL) {
        texels *= 2;
      }
      return texels;
    }

    double texelWidth() {
      return (left - right) / texels();
    }

    double texelHeight() {
      return (front - back) / texels();
    }

    double column(Vec3 point) {
      return (left - point.y()) / texelWidth();
    }

    double row(Vec3 point) {
      return (front - point.x()) / texelHeight();
    }
  }
}
