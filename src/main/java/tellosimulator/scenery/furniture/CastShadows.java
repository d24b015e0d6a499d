package tellosimulator.scenery.furniture;

import java.util.ArrayList;
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

  /** Edge of the texture [texels]: 2 cm each in a room of 5 m, which is less than it is blurred. */
  private static final int SIZE = 256;

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
    List<List<Vertex>> triangles = triangles(latest);
    FloorArea area = FloorArea.around(triangles, room);
    if (area.isEmpty()) {
      return List.of();
    }
    Texture texture = Texture.lazy(SIZE, SIZE, () -> texels(triangles, area));
    double texel = 1.0 / SIZE; // between the centres of the outer texels, or edges wrap around
    TextureRegion region = new TextureRegion(texel / 2, texel / 2, 1 - texel, 1 - texel);
    Mesh mesh = new MeshBuilder().quad(area.quad(), region).build();
    return List.of(Instance.atOrigin(new Part(mesh, texture, Shading.DECAL)));
  }

  /** All triangles of what is opaque, room frame. */
  private static List<List<Vertex>> triangles(List<Instance> obstacles) {
    List<Instance> opaque =
        obstacles.stream().filter(one -> !one.part().material().shading().blended()).toList();
    List<List<Vertex>> triangles = new ArrayList<>();
    for (Part part : MeshBatch.of(opaque)) {
      Mesh mesh = part.mesh();
      int[] faces = mesh.faceArray();
      for (int face = 0; face < faces.length; face += 9) {
        triangles.add(
            List.of(
                corner(mesh, faces[face]),
                corner(mesh, faces[face + 3]),
                corner(mesh, faces[face + 6])));
      }
    }
    return triangles;
  }

  private static Vertex corner(Mesh mesh, int position) {
    return new Vertex(mesh.position(position), Vec3.UP, 0, 0);
  }

  /** Where the shadow of a point falls. */
  private static Vec3 onFloor(Vec3 point) {
    return point.plusScaled(Lights.KEY, -point.z() / Lights.KEY.z());
  }

  /** Layer by layer: the higher it is, the softer its shadow. */
  private static int[] texels(List<List<Vertex>> triangles, FloorArea area) {
    double[] shaded = new double[SIZE * SIZE];
    for (int i = 0; i < LAYERS; i++) {
      double bottom = i * LAYER;
      double top = i < LAYERS - 1 ? bottom + LAYER : Double.POSITIVE_INFINITY;
      ShadowLayer layer = new ShadowLayer(SIZE);
      for (List<Vertex> triangle : triangles) {
        List<Vertex> lower = PolygonClip.clipped(triangle, Vec3.UP, top);
        List<Vertex> within = PolygonClip.clipped(lower, Vec3.UP.times(-1), -bottom);
        layer.fill(
            within.stream()
                .mapToDouble(vertex -> area.column(onFloor(vertex.position())))
                .toArray(),
            within.stream().mapToDouble(vertex -> area.row(onFloor(vertex.position()))).toArray());
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

  /**
   * The part of the floor that the texture covers, room frame [m]. The texture is seen from above,
   * x upwards, as on a plan.
   */
  private record FloorArea(double back, double front, double right, double left) {

    /** How far shadows may be blurred [m]. */
    private static final double MARGIN = 2 * (LEAST_BLUR + BLUR_BY_HEIGHT * LAYERS * LAYER);

    /** The smallest one with all shadows that are in the room. */
    static FloorArea around(List<List<Vertex>> triangles, Room room) {
      double all = Double.POSITIVE_INFINITY;
      FloorArea around = new FloorArea(all, -all, all, -all);
      for (List<Vertex> triangle : triangles) {
        for (Vertex corner : triangle) {
          around = around.with(onFloor(corner.position()));
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

    double texelWidth() {
      return (left - right) / SIZE;
    }

    double texelHeight() {
      return (front - back) / SIZE;
    }

    double column(Vec3 point) {
      return (left - point.y()) / texelWidth();
    }

    double row(Vec3 point) {
      return (front - point.x()) / texelHeight();
    }
  }
}
