package tellosimulator.view.world;

import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.CullFace;
import javafx.scene.shape.MeshView;
import javafx.scene.shape.TriangleMesh;
import javafx.scene.shape.VertexFormat;
import tellosimulator.math.Vec3;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.drone.DroneColors;

/**
 * The path that a drone has flown as a thin band in the air: one mesh, of which only the points
 * change, at most a few times a second.
 */
final class Trail extends MeshView {

  /** Most points. Decided: enough for minutes, cheap enough to update. */
  static final int CAPACITY = 384;

  /** Shortest time from update to update [ns]. Decided. */
  private static final long UPDATE_PERIOD = 120_000_000;

  /** Half the thickness [m]. Decided: one or two pixels across a room. */
  private static final double HALF_WIDTH = 0.0045;

  /** Height of the band above the drone's feet [m]. Documented: half of 41 mm. */
  private static final double MIDDLE = 0.02;

  private static final int SIDES = 3;

  private final FxDroneModel drone;
  private final TrailPath path = new TrailPath(CAPACITY);
  private final TriangleMesh mesh = new TriangleMesh(VertexFormat.POINT_NORMAL_TEXCOORD);
  private final float[] points = new float[CAPACITY * SIDES * 3];
  private boolean changed;
  private long lastUpdate;

  Trail(FxDroneModel drone) {
    this.drone = drone;
    initializeSelf();
    initializeParts();
  }

  /** Forgets the path; it begins anew where the drone is. */
  void clear() {
    path.clear();
    changed = true;
    lastUpdate = 0;
  }

  /**
   * Goes on to where the drone is.
   *
   * @param nanos the time of the picture [ns]
   */
  void advance(long nanos) {
    Vec3 position = drone.poseProperty().get().position();
    changed |= path.add(position.plusScaled(Vec3.UP, MIDDLE));
    if (changed && isVisible() && nanos - lastUpdate >= UPDATE_PERIOD) {
      lastUpdate = nanos;
      changed = false;
      update();
    }
  }

  /** Points of the path at present. */
  int size() {
    return path.size();
  }

  private void initializeSelf() {
    setId("trail-" + drone.number());
    setMesh(mesh);
    setCullFace(CullFace.NONE);
    Color color = DroneColors.of(drone.number());
    setMaterial(new PhongMaterial(color.deriveColor(0, 1, 1, 0.85)));
  }

  private void initializeParts() {
    mesh.getPoints().setAll(points);
    mesh.getNormals().setAll(0, 0, 1);
    mesh.getTexCoords().setAll(0, 0);
    for (int i = 1; i < CAPACITY; i++) {
      for (int side = 0; side < SIDES; side++) {
        int near = (i - 1) * SIDES;
        int next = (side + 1) % SIDES;
        addFace(near + side, near + next, near + SIDES + next);
        addFace(near + side, near + SIDES + next, near + SIDES + side);
      }
    }
  }

  private void addFace(int... vertices) {
    for (int vertex : vertices) {
      mesh.getFaces().addAll(vertex, 0, 0);
    }
  }

  /** All points beyond the last one lie where it lies, so that their triangles are empty. */
  private void update() {
    int last = Math.max(0, path.size() - 1);
    for (int i = 0; i < CAPACITY; i++) {
      if (path.size() == 0) {
        put(i, 0, Vec3.ZERO);
        put(i, 1, Vec3.ZERO);
        put(i, 2, Vec3.ZERO);
      } else {
        ring(i, Math.min(i, last), last);
      }
    }
    mesh.getPoints().set(0, points, 0, points.length);
  }

  private void ring(int index, int at, int last) {
    Vec3 point = path.point(at);
    Vec3 way = path.point(Math.min(last, at + 1)).minus(path.point(Math.max(0, at - 1)));
    Vec3 reference = Math.abs(way.z()) > 0.9 * way.norm() ? new Vec3(1, 0, 0) : Vec3.UP;
    Vec3 side = way.cross(reference).normalized().times(HALF_WIDTH);
    Vec3 up = side.cross(way).normalized().times(HALF_WIDTH);
    put(index, 0, point.plus(up));
    put(index, 1, point.plus(side).plusScaled(up, -0.5));
    put(index, 2, point.minus(side).plusScaled(up, -0.5));
  }

  private void put(int index, int side, Vec3 point) {
    int offset = (index * SIDES + side) * 3;
    points[offset] = (float) point.x();
    points[offset + 1] = (float) point.y();
    points[offset + 2] = (float) point.z();
  }
}
