package tellosimulator.view.world;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Texture;
import tellosimulator.view.FxDroneModel;

/** The path that a drone has flown, as the software camera draws it. For the JavaFX thread. */
final class DrawnTrail {

  private static final Pose ROOM = new Pose(Vec3.ZERO, Attitude.LEVEL);

  private final FxDroneModel drone;
  private final FollowsStart start;
  private final TrailPath path = new TrailPath(Trail.CAPACITY);
  private final Texture color;
  private Optional<Placed> part = Optional.empty();
  private boolean changed;
  private long lastUpdate;

  DrawnTrail(FxDroneModel drone) {
    this.drone = drone;
    start = new FollowsStart(drone);
    color = new Texture(1, 1, new int[] {drone.livery().color().argb()});
  }

  /**
   * Goes on to where the drone is.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos) {
    if (start.wasReset()) {
      path.clear();
      part = Optional.empty();
      lastUpdate = 0;
    }
    Vec3 position = drone.poseProperty().get().position();
    changed |= path.add(position.plusScaled(Vec3.UP, Trail.MIDDLE));
    if (changed && path.size() > 1 && nanos - lastUpdate >= Trail.UPDATE_PERIOD) {
      lastUpdate = nanos;
      changed = false;
      part = Optional.of(new Placed(new Part(mesh(), color, Finish.PAINTED), ROOM));
    }
  }

  /** As it is at present; none where there is no path yet. */
  Optional<Placed> part() {
    return part;
  }

  private Mesh mesh() {
    int sides = TrailPath.SIDES;
    float[] points = new float[3 * sides * path.size()];
    for (int i = 0; i < path.size(); i++) {
      List<Vec3> ring = path.ring(i);
      for (int side = 0; side < sides; side++) {
        Vec3 point = ring.get(side);
        int at = 3 * (i * sides + side);
        points[at] = (float) point.x();
        points[at + 1] = (float) point.y();
        points[at + 2] = (float) point.z();
      }
    }
    int[] corners = new int[9 * 2 * sides * (path.size() - 1)];
    for (int i = 0; i < 2 * sides * (path.size() - 1); i++) {
      face(corners, i);
    }
    return new Mesh(points, new float[] {0, 0, 1}, new float[] {0, 0}, corners);
  }

  /** Every two triangles are a rectangle from ring to ring. All have one normal and one colour. */
  private static void face(int[] corners, int number) {
    int sides = TrailPath.SIDES;
    int ring = number / (2 * sides) * sides;
    int side = number / 2 % sides;
    int next = (side + 1) % sides;
    boolean first = number % 2 == 0;
    corners[9 * number] = ring + side;
    corners[9 * number + 3] = first ? ring + next : ring + sides + next;
    corners[9 * number + 6] = ring + sides + (first ? next : side);
  }
}
