package tellosimulator.scenery.furniture;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Vertex;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.PolygonClip;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.scenery.texture.ProceduralTexture;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;

/**
 * The soft contact shadows of obstacles on the floor, as if light came from all sides. They are
 * made when obstacles or room change: a few meshes with one small texture, each for all shadows
 * that are about as dark, however many obstacles there are. For any thread.
 */
public final class ContactShadows {

  /** Shadows are as dark as one of so many steps. Decided: one does not see the next step. */
  private static final int STEPS = 12;

  /** Flat pieces of a round corner. Decided: by eye. */
  private static final int PIECES = 5;

  private static final int SIZE = 64;

  /** A round spot that fades out from its middle. */
  private static final Texture SPOT =
      ProceduralTexture.radial(SIZE, near -> Rgb.BLACK.argb(near * near));

  private static final Pose ORIGIN = new Pose(Vec3.ZERO, Attitude.LEVEL);

  private List<Obstacle> latest = List.of();
  private Room room = Room.DEFAULT;
  private List<Instance> instances = List.of();

  /** The shadows in a room, room frame; the same list for the same obstacles. */
  public synchronized List<Instance> instances(Room newRoom, List<Obstacle> obstacles) {
    if (obstacles != latest || !newRoom.equals(room)) {
      latest = obstacles;
      room = newRoom;
      instances = make();
    }
    return instances;
  }

  private List<Instance> make() {
    SortedMap<Integer, MeshBuilder> meshes = new TreeMap<>();
    for (Obstacle obstacle : latest) {
      for (ShadowCaster caster : ShadowCaster.of(obstacle.shape(), obstacle.foot().z())) {
        int step = (int) Math.round(STEPS * caster.opacity());
        if (step > 0) {
          add(meshes.computeIfAbsent(step, key -> new MeshBuilder()), caster, obstacle.pose());
        }
      }
    }
    List<Instance> made = new ArrayList<>();
    meshes.forEach(
        (step, mesh) -> {
          Part part = new Part(mesh.build(), SPOT, Shading.DECAL);
          made.add(new Instance(part, ORIGIN, 1, (double) step / STEPS));
        });
    return List.copyOf(made);
  }

  /** A band around the core that fades out; and the core, where one may see it. */
  private void add(MeshBuilder mesh, ShadowCaster caster, Pose obstacle) {
    ShadowCaster core = caster.core();
    List<Vertex> inner = outline(core, 0, obstacle);
    List<Vertex> outer = outline(core, caster.spread(), obstacle);
    Vertex middle = vertex(core.middle(), Vec3.ZERO, 0, obstacle);
    for (int i = 0; i < inner.size(); i++) {
      int next = (i + 1) % inner.size();
      add(mesh, List.of(inner.get(i), outer.get(i), outer.get(next)));
      add(mesh, List.of(inner.get(i), outer.get(next), inner.get(next)));
      if (!caster.stands()) {
        add(mesh, List.of(middle, inner.get(i), inner.get(next)));
      }
    }
  }

  /** The edge of a core, or a line so far outside of it [m]; counter-clockwise from above. */
  private static List<Vertex> outline(ShadowCaster core, double outside, Pose obstacle) {
    List<Vertex> outline = new ArrayList<>();
    for (int i = 0; i < 4 * (PIECES + 1); i++) {
      int corner = i / (PIECES + 1);
      double quarter = corner + (i % (PIECES + 1)) / (double) PIECES;
      Vec3 out =
          new Vec3(StrictMath.cos(quarter * Math.PI / 2), StrictMath.sin(quarter * Math.PI / 2), 0);
      double x = corner == 0 || corner == 3 ? core.halfDepth() : -core.halfDepth();
      double y = corner < 2 ? core.halfWidth() : -core.halfWidth();
      Vec3 edge = core.middle().plus(new Vec3(x, y, 0)).plusScaled(out, core.radius());
      outline.add(vertex(edge, out, outside, obstacle));
    }
    return outline;
  }

  /**
   * A vertex on the floor.
   *
   * @param edge on the edge of a core, in the frame of its obstacle [m]
   * @param out a unit vector
   * @param outside how far outside of the edge [m]
   */
  private static Vertex vertex(Vec3 edge, Vec3 out, double outside, Pose obstacle) {
    Vec3 place = obstacle.attitude().toRoom(edge.plusScaled(out, outside));
    double faded = outside > 0 ? 0.5 : 0;
    return new Vertex(
        obstacle.position().plus(place).withZ(0),
        Vec3.UP,
        0.5 + faded * out.x(),
        0.5 + faded * out.y());
  }

  /** Adds what of a triangle is inside of the room. */
  private void add(MeshBuilder mesh, List<Vertex> triangle) {
    mesh.polygon(PolygonClip.inside(triangle, room.depth() / 2, room.width() / 2));
  }
}
