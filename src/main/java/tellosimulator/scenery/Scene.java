package tellosimulator.scenery;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.mesh.Instance;

/**
 * Everything that can be seen at a moment, in layers that are drawn in this order. A renderer need
 * not look again at a list that is the same as before. Immutable; for any thread.
 *
 * @param room floor, walls and ceiling, and the decals on them; static
 * @param ground decals on the floor and on obstacles: shadows, mission pads, start marks
 * @param obstacles opaque but for the shade at their feet; static
 * @param drones bodies, lamps and propellers
 * @param overlay aids for people, which no drone's camera sees
 */
public record Scene(
    List<Instance> room,
    List<Instance> ground,
    List<Instance> obstacles,
    List<Instance> drones,
    List<Instance> overlay) {

  public Scene {
    room = List.copyOf(room);
    ground = List.copyOf(ground);
    obstacles = List.copyOf(obstacles);
    drones = List.copyOf(drones);
    overlay = List.copyOf(overlay);
  }

  /** A scene of instances that do not move. */
  public static Scene of(List<Instance> instances) {
    return new Scene(instances, List.of(), List.of(), List.of(), List.of());
  }

  public Scene withOverlay(List<Instance> newOverlay) {
    return new Scene(room, ground, obstacles, drones, newOverlay);
  }

  /** All instances in drawing order. */
  public List<Instance> instances() {
    List<Instance> all = new ArrayList<>(room);
    all.addAll(ground);
    all.addAll(obstacles);
    all.addAll(drones);
    all.addAll(overlay);
    return all;
  }
}
