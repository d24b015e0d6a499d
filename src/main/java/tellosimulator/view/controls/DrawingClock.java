package tellosimulator.view.controls;

import tellosimulator.view.model.FxSimulation;

/**
 * Says at which beats something is due that is drawn less often than once a frame. All that have
 * the same period are due at the same beat: a frame costs much where the processor draws. For the
 * JavaFX thread.
 */
final class DrawingClock {

  private final FxSimulation simulation;
  private final long movingNanos;
  private long takenNanos = Long.MIN_VALUE;

  /**
   * @param movingNanos time between two drawings while something moves [ns]; else it is longer
   */
  DrawingClock(FxSimulation simulation, long movingNanos) {
    this.simulation = simulation;
    this.movingNanos = movingNanos;
  }

  /** Whether a period has begun since what was due was last taken. */
  boolean due(long nanos) {
    long period = simulation.period(movingNanos);
    return nanos / period != takenNanos / period;
  }

  /** What was due has been done. */
  void take(long nanos) {
    takenNanos = nanos;
  }
}
