package tellosimulator.sim;

import java.util.List;
import java.util.OptionalInt;
import tellosimulator.command.Link;
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
 * The whole simulation at the end of a step, and what was commanded since. Immutable; for any
 * thread.
 *
 * @param time the end of the step
 * @param clock how simulated time relates to the wall clock
 * @param arena the room with all that is in it
 * @param drones in the order of their numbers
 */
public record SimSnapshot(SimTime time, Clock clock, Arena arena, List<DroneSnapshot> drones) {

  public Room room() {
    return arena.room();
  }

  /** What the room looks like. */
  public Decor decor() {
    return arena.decor();
  }

  /** The same moment with other drones. */
  public SimSnapshot withDrones(List<DroneSnapshot> newDrones) {
    return new SimSnapshot(time, clock, arena, newDrones);
  }

  /**
   * How simulated time relates to the wall clock.
   *
   * @param lostSeconds what was left out since the start, because the machine was too slow
   *     [simulated s]
   */
  public record Clock(TimeFactor factor, boolean paused, double lostSeconds) {

    /** Nothing is lost yet. */
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
   * @param link where its state and video go
   * @param product what it is
   * @param start where a reset puts it
   * @param rgb colour of its cover, as one writes #rrggbb; empty for that of its number
   * @param faults what goes wrong with it
   */
  public record DroneSnapshot(
      DroneState state,
      Link link,
      Product product,
      Pose start,
      OptionalInt rgb,
      ActiveFaults faults) {

    /** Without faults, in the colour of its number. */
    public DroneSnapshot(DroneState state, Link link, Product product, Pose start) {
      this(state, link, product, start, OptionalInt.empty(), ActiveFaults.NONE);
    }

    /**
     * The same drone in another colour.
     *
     * @param newRgb as one writes #rrggbb
     */
    public DroneSnapshot withColor(int newRgb) {
      return new DroneSnapshot(state, link, product, start, OptionalInt.of(newRgb), faults);
    }

    /** The same drone in another state. */
    public DroneSnapshot withState(DroneState newState) {
      return new DroneSnapshot(newState, link, product, start, rgb, faults);
    }
  }
}
