package tellosimulator.sim;

import java.util.List;
import tellosimulator.command.Link;
import tellosimulator.math.Pose;
import tellosimulator.model.DroneState;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.time.SimTime;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * The whole simulation at the end of a step, and what was commanded since. Immutable; for any
 * thread.
 *
 * @param time the end of the step
 * @param clock how simulated time relates to the wall clock
 * @param decor what the room looks like
 * @param drones in the order of their numbers
 */
public record SimSnapshot(
    SimTime time, Clock clock, Room room, Decor decor, List<DroneSnapshot> drones) {

  /** The same moment with other drones. */
  public SimSnapshot withDrones(List<DroneSnapshot> newDrones) {
    return new SimSnapshot(time, clock, room, decor, newDrones);
  }

  /** How simulated time relates to the wall clock. */
  public record Clock(TimeFactor factor, boolean paused) {}

  /**
   * A drone and its link to an operator.
   *
   * @param link where its state and video go
   * @param product what it is
   * @param start where a reset puts it
   */
  public record DroneSnapshot(DroneState state, Link link, Product product, Pose start) {

    /** The same drone in another state. */
    public DroneSnapshot withState(DroneState newState) {
      return new DroneSnapshot(newState, link, product, start);
    }
  }
}
