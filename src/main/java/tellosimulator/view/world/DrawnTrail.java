package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Mesh;
import tellosimulator.scenery.Part;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Texture;
import tellosimulator.view.FxDroneModel;

/** The paths that a drone has flown, as the software camera draws them. For the JavaFX thread. */
final class DrawnTrail {

  private static final Pose ROOM = new Pose(Vec3.ZERO, Attitude.LEVEL);

  private final FxDroneModel drone;
  private final FollowsStart start;
  private final FlightPaths paths = new FlightPaths(Trail.CAPACITY);
  private final int argb;
  private final Texture color;
  private List<Placed> earlier = List.of();
  private Optional<Placed> present = Optional.empty();
  private int shownChanges;
  private boolean changed;
  private long lastUpdate;

  DrawnTrail(FxDroneModel drone) {
    this.drone = drone;
    start = new FollowsStart(drone);
    argb = drone.livery().color().argb();
    color = new Texture(1, 1, new int[] {argb});
  }

  /**
   * Goes on to where the drone is.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos) {
    if (start.wasReset()) {
      paths.clear();
      lastUpdate = 0;
    }
    Vec3 position = drone.poseProperty().get().position();
    boolean takingOff = drone.phaseProperty().get() == FlightPhase.TAKING_OFF;
    changed |= paths.advance(takingOff, position.plusScaled(Vec3.UP, Trail.MIDDLE));
    if (paths.changes() != shownChanges) {
      shownChanges = paths.changes();
      present = Optional.empty();
      showEarlier();
    }
    if (changed && paths.present().size() > 1 && nanos - lastUpdate >= Trail.UPDATE_PERIOD) {
      lastUpdate = nanos;
      changed = false;
      present =
          Optional.of(new Placed(new Part(mesh(paths.present()), color, Finish.PAINTED), ROOM));
    }
  }

  private void showEarlier() {
    List<Placed> shown = new ArrayList<>();
    for (TrailPath path : paths.earlier()) {
      int alpha = (int) (255 * FlightPaths.opacity(shown.size() + 1));
      Texture faint = new Texture(1, 1, new int[] {(argb & 0xffffff) | (alpha << 24)});
      shown.add(new Placed(new Part(mesh(path), faint, Finish.SHEER), ROOM));
    }
    earlier = List.copyOf(shown);
  }

  /** The paths at present; the same ones as long as nothing has changed. */
  List<Placed> parts() {
    List<Placed> parts = new ArrayList<>(earlier);
    present.ifPresent(parts::add);
    return parts;
  }

  private static Mesh mesh(TrailPath path) {
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
