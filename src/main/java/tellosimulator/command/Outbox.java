package tellosimulator.command;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.DoubleSupplier;
import tellosimulator.time.SimTime;

/**
 * Replies on their way out, in order; those to be given at once may take a moment, as on the real
 * link. For the simulation thread.
 */
public final class Outbox {

  private record Waiting(SimTime due, Peer peer, String text) {}

  private final ReplyPort port;
  private final DoubleSupplier immediateDelay;
  private final Deque<Waiting> waiting = new ArrayDeque<>();
  private SimTime now = SimTime.ZERO;

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
    waiting.add(new Waiting(due, peer, text));
  }

  /** Sends what is due. */
  public void flush(SimTime time) {
    now = time;
    while (!waiting.isEmpty() && !now.isBefore(waiting.peek().due())) {
      Waiting reply = waiting.remove();
      port.reply(reply.peer(), reply.text());
    }
  }

  public boolean isEmpty() {
    return waiting.isEmpty();
  }

  /** Drops what was not sent, as a drone does that loses its power. */
  public void clear() {
    waiting.clear();
  }
}
