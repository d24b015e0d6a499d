package tellosimulator.view.world;

import java.util.Collections;
import java.util.List;
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
  static final long UPDATE_PERIOD = 120_000_000;

  /** Height of the band above the drone's feet [m]. Documented: half of 41 mm. */
  static final double MIDDLE = 0.02;

  private final FxDroneModel drone;
  private final TrailPath path = new TrailPath(CAPACITY);
  private final TriangleMesh mesh = new TriangleMesh(VertexFormat.POINT_NORMAL_TEXCOORD);
  private final float[] points = new float[CAPACITY * TrailPath.SIDES * 3];
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
    Color color = DroneColors.of(drone);
    setMaterial(new PhongMaterial(color.deriveColor(0, 1, 1, 0.85)));
  }

  private void initializeParts() {
    mesh.getPoints().setAll(points);
    mesh.getNormals().setAll(0, 0, 1);
    mesh.getTexCoords().setAll(0, 0);
    for (int i = 1; i < CAPACITY; i++) {
      for (int side = 0; side < TrailPath.SIDES; side++) {
        int near = (i - 1) * TrailPath.SIDES;
        int next = (side + 1) % TrailPath.SIDES;
        addFace(near + side, near + next, near + TrailPath.SIDES + next);
        addFace(near + side, near + TrailPath.SIDES + next, near + TrailPath.SIDES + side);
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
    List<Vec3> nothing = Collections.nCopies(TrailPath.SIDES, Vec3.ZERO);
    for (int i = 0; i < CAPACITY; i++) {
      List<Vec3> ring = path.size() == 0 ? nothing : path.ring(Math.min(i, last));
      for (int side = 0; side < TrailPath.SIDES; side++) {
        put(i * TrailPath.SIDES + side, ring.get(side));
      }
    }
    mesh.getPoints().set(0, points, 0, points.length);
  }

  private void put(int index, Vec3 point) {
    points[3 * index] = (float) point.x();
    points[3 * index + 1] = (float) point.y();
    points[3 * index + 2] = (float) point.z();
  }
}
