package tellosimulator.export;

import tellosimulator.recording.RecordedRun;
import tellosimulator.time.WallTime;

/**
 * The times that other tools see: those of the simulation, counted from the wall clock at the
 * takeoff, so that a flight as fast as possible looks like one in real time. Immutable; for any
 * thread.
 */
final class ExportClock {

  private static final double MICROS = 1e6;

  private final long origin;

  ExportClock(RecordedRun run) {
    origin = WallTime.micros(run.begun()).orElse(0) - Math.round(run.started() * MICROS);
  }

  /**
   * A moment.
   *
   * @param time simulated seconds since the simulation began
   * @return microseconds since 1970
   */
  long micros(double time) {
    return origin + Math.round(time * MICROS);
  }
}
