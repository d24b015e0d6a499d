package tellosimulator.scenery;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.scenery.mesh.Instance;

/**
 * Everything that is visible at one moment, in layers that are drawn in the order of the
 * parameters. Immutable. If a list is the same object as in the previous scene, a renderer can skip
 * it.
 *
 * @param room floor, walls and ceiling, and the decals on them; static
 * @param ground decals on the floor and on obstacles: shadows, mission pads, start positions
 * @param obstacles obstacles, which are opaque except for the shade at their feet; static
 * @param drones bodies, lamps and propellers
 * @param overlay visual aids for people; drones' cameras do not see them
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

  /** Creates a scene of instances that do not move. */
  public static Scene of(List<Instance> instances) {
    return new Scene(instances, List.of(), List.of(), List.of(), List.of());
  }

  public Scene withOverlay(List<Instance> newOverlay) {
    return new Scene(room, ground, obstacles, drones, newOverlay);
  }

  /** Returns all instances in drawing order. */
  public List<Instance> instances() {
    List<Instance> all = new ArrayList<>(room);
    all.addAll(ground);
    all.addAll(obstacles);
    all.addAll(drones);
    all.addAll(overlay);
    return all;
  }
}
