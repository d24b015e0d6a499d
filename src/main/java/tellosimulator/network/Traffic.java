package tellosimulator.network;

import java.util.concurrent.atomic.LongAdder;

/** Counts a drone's datagrams since the program started. For any thread. */
public final class Traffic {

  private final LongAdder received = new LongAdder();
  private final LongAdder sent = new LongAdder();
  private final LongAdder dropped = new LongAdder();

  void countReceived() {
    received.increment();
  }

  void countDropped() {
    dropped.increment();
  }

  void countSent() {
    sent.increment();
  }

  /** Datagrams that came to the drone's command port. */
  public long received() {
    return received.sum();
  }

  /** Those of the received ones that were turned away before the simulation saw them. */
  public long dropped() {
    return dropped.sum();
  }

  /** Datagrams that left from there: replies and state lines. */
  public long sent() {
    return sent.sum();
  }
}
