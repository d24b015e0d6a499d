package tellosimulator.video;

import java.util.function.LongSupplier;
import tellosimulator.command.Link;

/**
 * Whether an operator on another machine takes video, so that nothing is sent into a network that
 * nobody there takes or has asked for lately. Video for a program on this machine never rests. For
 * any thread.
 */
final class Reachability {

  /**
   * Silence of an operator after which nothing is sent [ns]. Decided: what nobody asks for is not
   * sent into a network for ever.
   */
  private static final long REST_AFTER = 120_000_000_000L;

  /**
   * How long it is tried again whether an operator takes video, and how often [ns]. Decided:
   * decoders take some seconds to open; a try is one small datagram.
   */
  private static final long TRIES = 10_000_000_000L;

  private static final long TRY_PERIOD = 1_500_000_000;

  private final LongSupplier clock;
  private volatile boolean unreachable;
  private volatile long unreachableNanos;
  private volatile long heardNanos;

  /**
   * Knows nothing yet.
   *
   * @param clock [ns]
   */
  Reachability(LongSupplier clock) {
    this.clock = clock;
  }

  /** The operator has sent something. */
  void heard() {
    heardNanos = clock.getAsLong();
    unreachable = false;
  }

  /** The operator's machine has said that nobody takes video there. */
  void unreachable() {
    unreachableNanos = clock.getAsLong();
    unreachable = true;
  }

  /** Whether nothing is to be sent now. */
  boolean rests(Link link) {
    long now = clock.getAsLong();
    boolean between = now - unreachableNanos < TRY_PERIOD;
    return remote(link)
        && (now - heardNanos > REST_AFTER || (unreachable && (between || !triesAgain(link))));
  }

  /** Whether it is tried again and again, because programs open their port after streamon. */
  boolean triesAgain(Link link) {
    return remote(link) && unreachable && clock.getAsLong() - heardNanos < TRIES;
  }

  private static boolean remote(Link link) {
    return link.operator().filter(operator -> !operator.local()).isPresent();
  }
}
