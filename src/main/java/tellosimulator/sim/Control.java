package tellosimulator.sim;

import java.util.List;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.TimeFactor;
import tellosimulator.world.Decor;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;
import tellosimulator.world.Wind;

/**
 * An action on the simulation itself, for example by the user, as opposed to a command from an
 * operator program. Controls pass through the same queue as commands. They are applied in order of
 * arrival, between two steps.
 */
public sealed interface Control {

  /** A control that concerns one drone. */
  sealed interface ForDrone extends Control {
    /** Returns the number of the drone, from 1. */
    int drone();
  }

  /** Switches a drone on or off. */
  record Power(int drone, boolean on) implements ForDrone {}

  /** Returns a drone to its start, as if newly placed there. */
  record Reset(int drone) implements ForDrone {}

  /**
   * Lands an airborne drone because its program has ended. Has no effect on a drone that is not
   * airborne.
   */
  record Land(int drone) implements ForDrone {}

  /**
   * Releases a drone from its operator. The next sender of {@code command} becomes its operator.
   */
  record Release(int drone) implements ForDrone {}

  /**
   * Sets the charge of a drone's battery.
   *
   * @param percent 0 to 100
   */
  record SetBattery(int drone, double percent) implements ForDrone {
    public SetBattery {
      if (!(percent >= 0 && percent <= 100)) {
        throw new IllegalArgumentException(
            "battery is " + percent + " %, but must be from 0 to 100");
      }
    }
  }

  /**
   * Moves a drone's start. A resting drone moves with its start, and is pushed out in the next step
   * if it overlaps something there.
   *
   * @param position the start on the floor, in the room frame [m]
   * @param heading the direction of the drone's nose [rad], counter-clockwise seen from above
   */
  record SetStart(int drone, Vec3 position, double heading) implements ForDrone {

    /** Moves a drone's start, with the drone facing along the room's x axis. */
    public SetStart(int drone, Vec3 position) {
      this(drone, position, 0);
    }
  }

  /**
   * Changes a drone's product, and the ports for its state and video. Has an effect only while the
   * drone is off.
   */
  record Configure(int drone, Product product, StreamPorts streamPorts) implements ForDrone {}

  /**
   * Lets simulated time pass. At time factor {@code max}, it otherwise stands still while nothing
   * moves.
   *
   * @param seconds the duration from now on [simulated s]
   */
  record PassTime(double seconds) implements Control {}

  /**
   * Ends the attempt at the goals: open goals can no longer be reached. Has no effect on the
   * drones.
   */
  record EndAttempt() implements Control {}

  /**
   * Restarts the simulation at time 0 with all drones off, as if the program had just started. All
   * previous state is discarded, so the same commands have the same effects again.
   *
   * @param config the configuration of the new run, with as many drones as before
   */
  record NewRun(SimConfig config) implements Control {}

  /** Changes the room. Drones and starts that would be outside are moved inside. */
  record SetRoom(Room room) implements Control {}

  /**
   * Replaces the obstacles and mission pads, and nothing else. A drone that overlaps a new obstacle
   * is pushed out.
   */
  record Furnish(List<Obstacle> obstacles, List<MissionPad> pads) implements Control {
    public Furnish {
      obstacles = List.copyOf(obstacles);
      pads = List.copyOf(pads);
    }
  }

  /** Adds a fault. It begins at once unless it has a later trigger. */
  record InjectFault(Fault fault) implements Control {}

  /** Ends all faults. The link quality stays the same. */
  record ClearFaults() implements Control {}

  /** Sets the link quality of all drones. */
  record SetLink(LinkPreset link) implements Control {}

  /** Replaces the wind, and nothing else. */
  record SetWind(Wind wind) implements Control {}

  /** Changes the appearance of the room. */
  record Decorate(Decor decor) implements Control {}

  /** Pauses or resumes simulated time. */
  record Pause(boolean paused) implements Control {}

  /** Sets the speed of simulated time. */
  record SetTimeFactor(TimeFactor factor) implements Control {}
}
