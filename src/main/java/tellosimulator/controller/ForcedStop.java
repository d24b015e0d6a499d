package tellosimulator.controller;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.command.Reply;
import tellosimulator.command.Responder;
import tellosimulator.model.Motion;
import tellosimulator.time.SimTime;

/**
 * The second answer to {@code stop}: it comes when the drone stands still, half a second to a
 * second later, or when something else has begun. For one drone and the simulation thread.
 */
final class ForcedStop {

  /** Earliest time of the answer [s]. Measured: 0.5 to 1 s later. */
  private static final double EARLIEST = 0.5;

  /** Time of the answer when something else moves the drone [s]. Measured: 0.5 to 1 s later. */
  private static final double LATEST = 1;

  /** Answers that wait at the most; a flood of {@code stop} gets no more. */
  private static final int MOST_WAITING = 100;

  private record Waiting(Responder responder, SimTime since) {}

  private final List<Waiting> waiting = new ArrayList<>();

  void expect(Responder responder, SimTime now) {
    if (waiting.size() < MOST_WAITING) {
      waiting.add(new Waiting(responder, now));
    }
  }

  boolean pending() {
    return !waiting.isEmpty();
  }

  void forget() {
    waiting.clear();
  }

  /**
   * Answers those whose time has come.
   *
   * @param hovering whether neither a command nor {@code rc} moves the drone
   */
  void report(SimTime now, Motion motion, boolean hovering) {
    if (waiting.isEmpty()) {
      return;
    }
    boolean still = hovering && motion.velocity().norm() < Flight.STILL;
    double due = still ? EARLIEST : LATEST;
    List<Waiting> ripe =
        waiting.stream()
            .filter(one -> now.since(one.since()) >= due && (still || !hovering))
            .toList();
    waiting.removeAll(ripe);
    ripe.forEach(one -> one.responder().reply(Reply.FORCED_STOP));
  }
}
