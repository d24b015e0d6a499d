package tellosimulator.export;

import tellosimulator.recording.RecordedRun;
import tellosimulator.time.WallTime;

/**
 * The times that other tools see: those of the simulation, counted from the wall clock at the
 * takeoff, so that a flight as fast as possible looks like one in real time. If that wall clock is
 * unknown or cannot be, they count from 1970. Immutable; for any thread.
 */
final class ExportClock {

  private static final double MICROS = 1e6;

  /** The last moment that a capture file can hold [µs]: its seconds have 32 bits. */
  private static final double LAST = 0xffff_ffffL * MICROS;

  private final double origin;

  ExportClock(RecordedRun run) {
    double begun = WallTime.micros(run.begun()).orElse(0);
    origin = (begun >= 0 && begun <= LAST ? begun : 0) - run.started() * MICROS;
  }

  /**
   * A moment.
   *
   * @param time simulated seconds since the simulation began
   * @return microseconds since 1970
   */
  long micros(double time) {
    return Math.round(Math.max(0, Math.min(LAST, origin + time * MICROS)));
  }
}
