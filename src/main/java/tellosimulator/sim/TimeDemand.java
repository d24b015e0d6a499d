package tellosimulator.sim;

import java.util.List;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.time.Demand;
import tellosimulator.time.SimTime;

/**
 * Why simulated time must pass, and whether a datagram may be taken before it has. For the
 * simulation thread.
 */
final class TimeDemand {

  /**
   * How long a datagram waits at the most for what earlier ones have caused [s]. Decided: longer
   * than a drone takes to restart; some things never end, such as a landing on a hovering drone.
   */
  private static final double LONGEST_DEBT = 20;

  private final List<SimDrone> drones;
  private SimTime lastTaken = SimTime.ZERO;
  private SimTime passUntil = SimTime.ZERO;

  /**
   * @param drones the list itself, in which drones may be replaced
   */
  TimeDemand(List<SimDrone> drones) {
    this.drones = drones;
  }

  /** A datagram is taken. */
  void taken(SimTime now) {
    lastTaken = now;
  }

  /** Time must pass until then, whatever else happens. */
  void passUntil(SimTime moment) {
    passUntil = passUntil.isBefore(moment) ? moment : passUntil;
  }

  /** Why time must pass now. */
  Demand demand(SimTime now) {
    Demand demand = now.isBefore(passUntil) ? Demand.DEBT : Demand.NONE;
    for (SimDrone drone : drones) {
      demand = demand.or(drone.demand());
    }
    return demand == Demand.DEBT && late(now) ? Demand.MOTION : demand;
  }

  /** Whether what datagrams have caused takes longer than others can wait for. */
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
   * Whether a datagram may be taken now. As fast as possible, when it comes tells nothing about
   * simulated time, which runs until everything is over that the datagrams before it have caused:
   * so the next one is taken at a moment that depends on these alone. Only while somebody waits for
   * an answer anything is taken at once, because it may be meant to interrupt.
   */
  boolean open(SimTime now, Clock clock) {
    return !clock.factor().unlimited() || clock.paused() || demand(now) != Demand.DEBT || answers();
  }
}
