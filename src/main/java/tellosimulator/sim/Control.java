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
 * What people do to the simulation, as opposed to what operator programs do. It is taken from the
 * same queue as commands, in the order in which they came, between two steps.
 */
public sealed interface Control {

  /** A control that concerns one drone. */
  sealed interface ForDrone extends Control {
    /** Its number, from 1. */
    int drone();
  }

  /** The power switch. */
  record Power(int drone, boolean on) implements ForDrone {}

  /** Back to the start, as if it had just been put there. */
  record Reset(int drone) implements ForDrone {}

  /** Lands a drone that is in the air, because its program has ended; others stay as they are. */
  record Land(int drone) implements ForDrone {}

  /** Takes a drone from its operator: the next sender of {@code command} gets it. */
  record Release(int drone) implements ForDrone {}

  /**
   * Charges or drains the battery.
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
   * Puts a drone's start elsewhere, and the drone too if it stands on the ground; out of what is
   * there already, it moves at once.
   *
   * @param position on the floor, room frame [m]
   * @param heading where its nose points [rad], counter-clockwise seen from above
   */
  record SetStart(int drone, Vec3 position, double heading) implements ForDrone {

    /** A start at which the drone looks along the room's x. */
    public SetStart(int drone, Vec3 position) {
      this(drone, position, 0);
    }
  }

  /**
   * Makes another product of a drone, and lets its state and video go elsewhere; only while it is
   * off.
   */
  record Configure(int drone, Product product, StreamPorts streamPorts) implements ForDrone {}

  /**
   * Lets time pass where it would stand still, because it runs as fast as possible and nothing
   * moves.
   *
   * @param seconds how long from now on [simulated s]
   */
  record PassTime(double seconds) implements Control {}

  /**
   * Begins the simulation anew, at moment 0 and with all drones off, as if the program had just
   * started; what came before it is forgotten. The same commands then have the same effects.
   *
   * @param config with as many drones as before
   */
  record Restart(SimConfig config) implements Control {}

  /** Another room; drones and starts that would be outside move in. */
  record SetRoom(Room room) implements Control {}

  /**
   * Other obstacles and mission pads; everything else stays. Drones that would be in something move
   * out of it.
   */
  record Furnish(List<Obstacle> obstacles, List<MissionPad> pads) implements Control {
    public Furnish {
      obstacles = List.copyOf(obstacles);
      pads = List.copyOf(pads);
    }
  }

  /** One more fault, which begins at once unless it waits for something. */
  record InjectFault(Fault fault) implements Control {}

  /** No fault any more; the link stays as good as it is. */
  record ClearFaults() implements Control {}

  /** How good the link of all drones is from now on. */
  record SetLink(LinkPreset link) implements Control {}

  /** Another wind; everything else stays. */
  record SetWind(Wind wind) implements Control {}

  /** Other looks of the room. */
  record Decorate(Decor decor) implements Control {}

  /** Lets simulated time stand still, or go on. */
  record Pause(boolean paused) implements Control {}

  /** How fast simulated time passes. */
  record SetTimeFactor(TimeFactor factor) implements Control {}
}
