package tellosimulator.sim;

import java.util.List;
import java.util.OptionalInt;
import tellosimulator.command.OperatorEndpoint;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.math.Pose;
import tellosimulator.model.DroneState;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.time.SimTime;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

/**
 * The state of the whole simulation at the end of a step, including the effects of commands applied
 * since that step. Immutable.
 *
 * @param time the end of the step
 * @param clock the relation of simulated time to wall clock time
 * @param seed the seed of all random numbers
 * @param arena the room with its contents
 * @param drones in the order of their numbers
 */
public record SimSnapshot(
    SimTime time, Clock clock, long seed, Arena arena, List<DroneSnapshot> drones) {

  public Room room() {
    return arena.room();
  }

  /** Returns the appearance of the room. */
  public Decor decor() {
    return arena.decor();
  }

  /** Returns a copy with other drones. */
  public SimSnapshot withDrones(List<DroneSnapshot> newDrones) {
    return new SimSnapshot(time, clock, seed, arena, newDrones);
  }

  /**
   * The relation of simulated time to wall clock time.
   *
   * @param lostSeconds the time skipped since the start, because the machine was too slow
   *     [simulated s]
   */
  public record Clock(TimeFactor factor, boolean paused, double lostSeconds) {

    /** Creates a clock without lost time. */
    public Clock(TimeFactor factor, boolean paused) {
      this(factor, paused, 0);
    }

    Clock withFactor(TimeFactor newFactor) {
      return new Clock(newFactor, paused, lostSeconds);
    }

    Clock withPaused(boolean newPaused) {
      return new Clock(factor, newPaused, lostSeconds);
    }

    Clock withLost(double newLostSeconds) {
      return new Clock(factor, paused, newLostSeconds);
    }
  }

  /**
   * A drone and its link to an operator.
   *
   * @param link the operator to whose host the drone sends state and video
   * @param product the drone's product and reference model
   * @param start the drone's pose after a reset
   * @param rgb the colour of the drone's cover, as in #rrggbb; empty for the default colour of its
   *     number
   * @param faults the faults that affect the drone
   */
  public record DroneSnapshot(
      DroneState state,
      OperatorEndpoint link,
      Product product,
      Pose start,
      OptionalInt rgb,
      ActiveFaults faults) {

    /** Creates the snapshot of a drone without faults, in the default colour of its number. */
    public DroneSnapshot(DroneState state, OperatorEndpoint link, Product product, Pose start) {
      this(state, link, product, start, OptionalInt.empty(), ActiveFaults.NONE);
    }

    /**
     * Returns a copy in another colour.
     *
     * @param newRgb as in #rrggbb
     */
    public DroneSnapshot withColor(int newRgb) {
      return new DroneSnapshot(state, link, product, start, OptionalInt.of(newRgb), faults);
    }

    /** Returns a copy with another drone state. */
    public DroneSnapshot withState(DroneState newState) {
      return new DroneSnapshot(newState, link, product, start, rgb, faults);
    }
  }
}
