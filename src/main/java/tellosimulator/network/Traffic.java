package tellosimulator.network;

import java.util.concurrent.atomic.LongAdder;

/** Counts the datagrams of a drone, beginning when the program starts. Thread-safe. */
public final class Traffic {

  private final LongAdder received = new LongAdder();
  private final LongAdder sent = new LongAdder();

  void countReceived() {
    received.increment();
  }

  void countSent() {
    sent.increment();
  }

  /**
   * Returns the number of datagrams received at the drone's command port, including rejected ones.
   */
  public long received() {
    return received.sum();
  }

  /** Returns the number of datagrams sent from the command port: replies and state lines. */
  public long sent() {
    return sent.sum();
  }
}
