package tellosimulator.command;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.function.DoubleSupplier;
import tellosimulator.time.SimTime;

/**
 * Replies on their way out, in order; those to be given at once may take a moment, as on the real
 * link. How many wait is bounded, in all and for each peer, because time may stand still: the
 * oldest is dropped. For the simulation thread.
 */
public final class Outbox {

  /** Replies that may wait for one peer. Decided: more than anybody asks within the delay. */
  static final int MOST_FOR_PEER = 1024;

  /** Replies that may wait in all. Decided: some megabytes, whatever they echo. */
  static final int MOST = 4096;

  private record Waiting(SimTime due, Peer peer, String text) {}

  private final ReplyPort port;
  private final DoubleSupplier immediateDelay;
  private final Deque<Waiting> waiting = new ArrayDeque<>();
  private final Map<Peer, Integer> counts = new HashMap<>();
  private SimTime now = SimTime.ZERO;
  private long dropped;

  /**
   * @param immediateDelay asked for each immediate reply for what it takes [s]
   */
  public Outbox(ReplyPort port, DoubleSupplier immediateDelay) {
    this.port = port;
    this.immediateDelay = immediateDelay;
  }

  SimTime now() {
    return now;
  }

  /**
   * Queues a reply.
   *
   * @param asked when the command came; the reply is immediate if that is now
   */
  void add(Peer peer, String text, SimTime asked) {
    SimTime due = asked.equals(now) ? now.plus(immediateDelay.getAsDouble()) : now;
    if (!waiting.isEmpty() && due.isBefore(waiting.getLast().due())) {
      due = waiting.getLast().due();
    }
    makeRoom(peer);
    waiting.add(new Waiting(due, peer, text));
    counts.merge(peer, 1, Integer::sum);
  }

  private void makeRoom(Peer peer) {
    if (counts.getOrDefault(peer, 0) >= MOST_FOR_PEER) {
      dropOldest(peer);
    } else if (waiting.size() >= MOST) {
      countDown(waiting.remove().peer());
      dropped++;
    }
  }

  private void dropOldest(Peer peer) {
    Iterator<Waiting> oldest = waiting.iterator();
    boolean found = false;
    while (!found && oldest.hasNext()) {
      found = oldest.next().peer().equals(peer);
    }
    oldest.remove();
    countDown(peer);
    dropped++;
  }

  private void countDown(Peer peer) {
    counts.computeIfPresent(peer, (same, count) -> count == 1 ? null : count - 1);
  }

  /** How many replies found no room and were dropped since this was asked last. */
  public long takeDropped() {
    long taken = dropped;
    dropped = 0;
    return taken;
  }

  /** Whether replies were dropped since that was asked last. */
  public boolean hasDropped() {
    return dropped > 0;
  }

  /** Sends what is due. */
  public void flush(SimTime time) {
    now = time;
    while (!waiting.isEmpty() && !now.isBefore(waiting.peek().due())) {
      Waiting reply = waiting.remove();
      countDown(reply.peer());
      port.reply(reply.peer(), reply.text());
    }
  }

  public boolean isEmpty() {
    return waiting.isEmpty();
  }

  /** Drops what was not sent, as a drone does that loses its power. */
  public void clear() {
    waiting.clear();
    counts.clear();
  }
}
