package tellosimulator.video;

import java.util.function.LongSupplier;
import tellosimulator.command.OperatorEndpoint;

/**
 * Tracks whether an operator on another machine receives video. Video is not sent to another
 * machine if it is not received there, or if the operator has been silent for a long time. Video
 * for a program on this machine is always sent. Thread-safe.
 */
final class Reachability {

  /**
   * Duration of an operator's silence after which no more video is sent [ns]. Decided: video that
   * may no longer be wanted must not load a network forever.
   */
  private static final long REST_AFTER = 120_000_000_000L;

  /**
   * Time after the operator's last command during which sending to an unreachable port is retried
   * [ns]. Decided: decoders take some seconds to open their port.
   */
  private static final long TRIES = 10_000_000_000L;

  /** Interval between attempts [ns]. Decided: an attempt costs only one small datagram. */
  private static final long TRY_PERIOD = 1_500_000_000;

  private final LongSupplier clock;
  private volatile boolean unreachable;
  private volatile long unreachableNanos;
  private volatile long heardNanos;

  /**
   * Creates a tracker for an operator that has not sent anything yet.
   *
   * @param clock supplies the time [ns]
   */
  Reachability(LongSupplier clock) {
    this.clock = clock;
  }

  /** Records that the operator has sent something. */
  void heard() {
    heardNanos = clock.getAsLong();
    unreachable = false;
  }

  /** Records that the operator's machine has reported its video port as unreachable. */
  void unreachable() {
    unreachableNanos = clock.getAsLong();
    unreachable = true;
  }

  /** Returns whether sending is suspended. */
  boolean rests(OperatorEndpoint link) {
    long now = clock.getAsLong();
    boolean between = now - unreachableNanos < TRY_PERIOD;
    return remote(link)
        && (now - heardNanos > REST_AFTER || (unreachable && (between || !triesAgain(link))));
  }

  /**
   * Returns whether to try to send again even though the port was unreachable. Programs open their
   * port only after sending {@code streamon}, so the first datagram may be too early.
   */
  boolean triesAgain(OperatorEndpoint link) {
    return remote(link) && unreachable && clock.getAsLong() - heardNanos < TRIES;
  }

  private static boolean remote(OperatorEndpoint link) {
    return link.operator().filter(operator -> !operator.local()).isPresent();
  }
}
