package tellosimulator.network;

import java.util.concurrent.atomic.LongAdder;

/** Counts a drone's datagrams since the program started. For any thread. */
public final class Traffic {

  private final LongAdder received = new LongAdder();
  private final LongAdder sent = new LongAdder();

  void countReceived() {
    received.increment();
  }

  void countSent() {
    sent.increment();
  }

  /** Datagrams that came to the drone's command port, also those that were turned away. */
  public long received() {
    return received.sum();
  }

  /** Datagrams that left from there: replies and state lines. */
  public long sent() {
    return sent.sum();
  }
}
