package tellosimulator.sim;

import java.util.List;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.time.PendingWork;
import tellosimulator.time.SimTime;

/**
 * Determines why simulated time must pass, and whether it must pass before the next datagram is
 * handled. Confined to the simulation thread.
 */
final class TimeDemand {

  /**
   * Maximum time that a datagram waits for the effects of earlier datagrams to end [simulated s].
   * Decided: longer than a drone takes to restart. The limit is needed because some effects never
   * end, such as a landing on a hovering drone.
   */
  private static final double LONGEST_DEBT = 20;

  private final List<SimDrone> drones;
  private SimTime lastTaken = SimTime.ZERO;
  private SimTime passUntil = SimTime.ZERO;

  /**
   * Creates the time demand of a simulation's drones.
   *
   * @param drones the live list; drones in it may be replaced
   */
  TimeDemand(List<SimDrone> drones) {
    this.drones = drones;
  }

  /** Records that a datagram is handled now. */
  void taken(SimTime now) {
    lastTaken = now;
  }

  /** Requires time to pass until a given moment, whatever else happens. */
  void passUntil(SimTime moment) {
    passUntil = passUntil.isBefore(moment) ? moment : passUntil;
  }

  /** Returns the reason why time must pass now. */
  PendingWork demand(SimTime now) {
    PendingWork demand = now.isBefore(passUntil) ? PendingWork.REPLY : PendingWork.NONE;
    for (SimDrone drone : drones) {
      demand = demand.or(drone.demand());
    }
    return demand == PendingWork.REPLY && late(now) ? PendingWork.MOTION : demand;
  }

  /**
   * Whether the effects of earlier datagrams have lasted so long that other datagrams no longer
   * wait for them.
   */
  private boolean late(SimTime now) {
    return now.since(lastTaken) >= LONGEST_DEBT && !answers() && !now.isBefore(passUntil);
  }

  private boolean answers() {
    for (SimDrone drone : drones) {
      if (drone.answers()) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns whether a datagram may be handled now. At time factor {@code max}, the wall clock time
   * of a datagram's arrival has no relation to simulated time. Simulated time therefore runs until
   * all effects of earlier datagrams are over, so that the moment at which the next datagram is
   * handled depends on the earlier ones alone. However, while a client waits for a reply, every
   * datagram is handled at once, because it may be meant as an interruption.
   */
  boolean open(SimTime now, Clock clock) {
    return !clock.factor().unlimited()
        || clock.paused()
        || demand(now) != PendingWork.REPLY
        || answers();
  }
}
