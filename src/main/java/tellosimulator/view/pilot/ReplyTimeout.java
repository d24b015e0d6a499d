package tellosimulator.view.pilot;

/**
 * Decides when a reply is overdue. Time that the simulation spends in flight counts by its own
 * clock, however fast that runs, and nothing counts while it is paused.
 */
final class ReplyTimeout {

  /** Longest wait in simulated time [s]. Assumed: longer than any command of a tour takes. */
  static final double SIMULATED = 60;

  /**
   * Longest wait by the wall clock while simulated time stands still though nobody paused it: as
   * fast as possible means that it passes only while a drone has something to do [ns]. Assumed.
   */
  static final long IDLE_NANOS = 3_000_000_000L;

  /**
   * What both clocks say.
   *
   * @param nanos the wall clock's [ns]
   * @param seconds simulated time [s]
   */
  record Clocks(long nanos, double seconds, boolean paused) {}

  private final double began;
  private double seconds;
  private long movedNanos;

  ReplyTimeout(Clocks clocks) {
    began = clocks.seconds();
    seconds = clocks.seconds();
    movedNanos = clocks.nanos();
  }

  /** Looks at the clocks; whether the reply will not come any more. */
  boolean isOver(Clocks clocks) {
    if (clocks.paused() || clocks.seconds() != seconds) {
      seconds = clocks.seconds();
      movedNanos = clocks.nanos();
    }
    return seconds - began >= SIMULATED || clocks.nanos() - movedNanos >= IDLE_NANOS;
  }
}
