package tellosimulator.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.world.Room;

/** The formation in which drones stand before their flight. */
public final class Formation {

  /** Distance between neighbours [m]. Decided. */
  private static final double DISTANCE = 0.6;

  private Formation() {}

  /**
   * Returns the starts of drones that stand side by side along y, the first one on the left. If the
   * room is too narrow for all drones, the others stand in further rows behind the first.
   *
   * @param middle the middle of the first row, on the floor, in the room frame [m]
   * @throws IllegalArgumentException if the drones do not fit into the room
   */
  public static List<Pose> row(int drones, Vec3 middle, Room room) {
    int most = Math.max(1, mostSideBySide(middle, room));
    List<Pose> starts = new ArrayList<>();
    for (int i = 0; i < drones; i++) {
      int row = i / most;
      int inRow = Math.min(most, drones - row * most);
      double left = ((inRow - 1) / 2.0 - i % most) * DISTANCE;
      Vec3 start = middle.plus(new Vec3(-row * DISTANCE, left, 0));
      if (!room.contains(start, DroneSpec.COLLIDER)) {
        throw new IllegalArgumentException(
            String.format(
                Locale.ROOT,
                "drone %d does not fit into the room: its start would be at x %.0f, y %.0f cm",
                i + 1,
                start.x() * 100,
                start.y() * 100));
      }
      starts.add(new Pose(start, Attitude.LEVEL));
    }
    return starts;
  }

  private static int mostSideBySide(Vec3 middle, Room room) {
    double free = room.width() / 2 - DroneSpec.COLLIDER.radius() - Math.abs(middle.y());
    return (int) Math.floor(2 * free / DISTANCE) + 1;
  }
}
