package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * The overlay of a scene as one window shows it: trails, plumb lines and, where there are several
 * drones, number tags. It follows the drones from snapshot to snapshot. For one thread at a time.
 */
public final class Overlay {

  private final List<Trail> trails = new ArrayList<>();
  private final List<PlumbLine> plumbLines = new ArrayList<>();
  private final List<NumberTag> tags = new ArrayList<>();
  private boolean trailsShown = true;

  /**
   * @param first with as many drones as all that follow
   */
  public Overlay(SimSnapshot first) {
    for (DroneSnapshot drone : first.drones()) {
      Livery livery = Livery.of(drone);
      trails.add(new Trail(drone));
      plumbLines.add(new PlumbLine(livery));
      if (first.drones().size() > 1) {
        tags.add(new NumberTag(drone.state().drone(), livery));
      }
    }
  }

  /** Shows the trails, or hides them. */
  public void showTrails(boolean shown) {
    trailsShown = shown;
  }

  /** Begins all trails anew. */
  public void clearTrails() {
    trails.forEach(Trail::clear);
  }

  /**
   * Moves on to a snapshot.
   *
   * @param nanos of any steady clock [ns]
   */
  public void advance(SimSnapshot snapshot, long nanos) {
    for (int i = 0; i < trails.size(); i++) {
      trails.get(i).advance(snapshot.drones().get(i), nanos);
    }
  }

  /**
   * The overlay of a snapshot, in drawing order.
   *
   * @param camera from where people look, room frame
   */
  public List<Instance> instances(SimSnapshot snapshot, Pose camera) {
    List<Instance> instances = new ArrayList<>();
    if (trailsShown) {
      trails.forEach(trail -> instances.addAll(trail.instances()));
    }
    List<DroneSnapshot> drones = snapshot.drones();
    for (int i = 0; i < plumbLines.size(); i++) {
      Pose pose = drones.get(i).state().motion().pose();
      plumbLines.get(i).from(pose.position(), camera.position()).ifPresent(instances::add);
    }
    for (int i = 0; i < tags.size(); i++) {
      instances.add(tags.get(i).above(drones.get(i).state().motion().position(), camera));
    }
    return instances;
  }
}
