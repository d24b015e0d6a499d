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
 * The soft shadows of obstacles on the floor, cast by two lights. The shadow in the key light shows
 * where a gate stands and how high it is; the shadow in the light from above shows what touches the
 * floor. All shadows are baked into one texture whenever the obstacles or the room change, and are
 * drawn as one decal. Thread-safe.
 */
public final class FloorShadows {

  /**
   * Maximum side length of a texel, unless {@link #MOST_TEXELS} requires larger texels [m].
   * Decided: less than the width of a post.
   */
  private static final double TEXEL = 0.025;

  private static final int LEAST_TEXELS = 128;

  /**
   * Maximum side length of the texture [texels]. Decided: a larger texture would take too long to
   * bake while an obstacle is being moved.
   */
  private static final int MOST_TEXELS = 1024;

  /**
   * If the obstacles have more triangles than this, they cast no shadows. Decided: the limit
   * corresponds to hundreds of gates, whose shadows would not be distinguishable, and to a baking
   * time of a quarter of a second.
   */
  private static final int MOST_TRIANGLES = 200_000;

  /**
   * A light whose shadows are baked. The obstacles are cut into horizontal layers; within the
   * shadow of one layer, all edges are equally soft. The uppermost layer has no upper limit.
   * Decided: all values, by eye.
   *
   * @param direction direction in which the light shines, in the room frame
   * @param darkest opacity where no light arrives
   * @param layer thickness of a layer [m]
   * @param leastBlur blur of the shadow of an edge at floor height [m]
   * @param blurByHeight additional blur for each metre of the edge's height above the floor
   */
  private record Light(
      Vec3 direction, double darkest, double layer, double leastBlur, double blurByHeight) {

    static final Light KEY = new Light(Lights.KEY, 0.3, 0.6, 0.015, 0.03);

    static final Light ABOVE = new Light(Vec3.UP.times(-1), 0.55, 0.2, 0.02, 0.35);

    /** Projects a point above the floor onto the floor; both points are in the room frame [m]. */
    Vec3 onFloor(Vec3 point) {
      return point.plusScaled(direction, -point.z() / direction.z());
    }

    /** Returns the blur of the shadow from a layer [m]. */
    double blur(int number) {
      return leastBlur + blurByHeight * layer * (number + 0.5);
    }
  }

  private static final int LAYERS = 4;

  private List<Instance> latest = List.of();
  private Room room = Room.DEFAULT;
  private List<Instance> instances = List.of();

  /**
   * Returns the shadows on the floor of a room, in the room frame. The list stays the same object
   * until the obstacles or the room change.
   *
   * @param obstacles instances of the obstacles, as they are drawn
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
    Mesh mesh = new MeshBuilder().quad(area.quad(), TextureRegion.unwrapped(texture)).build();
    return List.of(Instance.atOrigin(new Part(mesh, texture, Shading.DECAL)));
  }

  private static int[] texels(List<Mesh> meshes, FloorArea area) {
    double[] key = shaded(meshes, area, Light.KEY);
    double[] above = shaded(meshes, area, Light.ABOVE);
    int[] argb = new int[key.length];
    for (int i = 0; i < argb.length; i++) {
      argb[i] = Rgb.BLACK.argb(1 - (1 - key[i]) * (1 - above[i]));
    }
    return argb;
  }

  /**
   * Computes the opacity of each texel layer by layer: the higher a layer, the softer its shadow.
   */
  private static double[] shaded(List<Mesh> meshes, FloorArea area, Light light) {
    double[] shaded = new double[area.texels() * area.texels()];
    for (int i = 0; i < LAYERS; i++) {
      double bottom = i * light.layer;
      double top = i < LAYERS - 1 ? bottom + light.layer : Double.POSITIVE_INFINITY;
      ShadowLayer layer = new ShadowLayer(area.texels());
      for (Mesh mesh : meshes) {
        fill(layer, mesh, bottom, top, area, light);
      }
      layer.blur(light.blur(i) / area.texelWidth(), light.blur(i) / area.texelHeight());
      layer.addTo(shaded);
    }
    Arrays.setAll(shaded, i -> light.darkest * Math.min(1, shaded[i]));
    return shaded;
  }

  /** Fills the shadow of the part of a mesh between two heights [m]. */
  private static void fill(
      ShadowLayer layer, Mesh mesh, double bottom, double top, FloorArea area, Light light) {
    int[] faces = mesh.faceArray();
    for (int face = 0; face < faces.length; face += 9) {
      Vec3 a = mesh.position(faces[face]);
      Vec3 b = mesh.position(faces[face + 3]);
      Vec3 c = mesh.position(faces[face + 6]);
      double lowest = Math.min(a.z(), Math.min(b.z(), c.z()));
      double highest = Math.max(a.z(), Math.max(b.z(), c.z()));
      if (lowest < top && highest >= bottom) {
        List<Vertex> lower = PolygonClip.clipped(triangle(a, b, c), Vec3.UP, top);
        List<Vertex> within = PolygonClip.clipped(lower, Vec3.UP.times(-1), -bottom);
        List<Vec3> shadow = within.stream().map(one -> light.onFloor(one.position())).toList();
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
   * The part of the floor that the texture covers, in the room frame [m]. The texture shows the
   * floor from above, with x upwards, as on a plan.
   */
  private record FloorArea(double back, double front, double right, double left) {

    /** Maximum extent of the blur [m]. */
    private static final double MARGIN = 2 * Light.ABOVE.blur(LAYERS);

    /** Returns the smallest area that contains all shadows inside the room. */
    static FloorArea around(List<Mesh> meshes, Room room) {
      double all = Double.POSITIVE_INFINITY;
      FloorArea around = new FloorArea(all, -all, all, -all);
      for (Mesh mesh : meshes) {
        for (int i = 0; i < mesh.positions(); i++) {
          around = around.with(mesh.position(i)).with(Light.KEY.onFloor(mesh.position(i)));
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

    /**
     * Returns the side length of the texture [texels]. It is the smallest power of two that gives
     * texels of at most {@link FloorShadows#TEXEL}, within the limits.
     */
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
