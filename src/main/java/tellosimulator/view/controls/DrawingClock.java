package tellosimulator.view.controls;

import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.ViewContext;

/**
 * Determines when to redraw a part that is drawn less often than once a frame. All clocks with the
 * same period are due at the same tick, because each frame is expensive with software rendering.
 * Confined to the JavaFX thread.
 */
final class DrawingClock {

  private final FxSimulation simulation;
  private final long movingNanos;
  private long takenNanos = Long.MIN_VALUE;

  /**
   * @param movingNanos the period while something moves [ns]; while nothing moves, the period is
   *     longer
   */
  DrawingClock(FxSimulation simulation, long movingNanos) {
    this.simulation = simulation;
    this.movingNanos = movingNanos;
  }

  /**
   * Runs an update once per period. While actions are pending, the update is postponed, because it
   * would show outdated values.
   */
  static void run(ViewContext context, long movingNanos, Runnable update) {
    DrawingClock clock = new DrawingClock(context.simulation(), movingNanos);
    context
        .ticker()
        .onTick(
            nanos -> {
              if (!context.actions().pending() && clock.due(nanos)) {
                update.run();
              }
            });
  }

  /** Returns whether a new period has begun since this method last returned true. */
  boolean due(long nanos) {
    long period = simulation.period(movingNanos);
    boolean due = nanos / period != takenNanos / period;
    takenNanos = due ? nanos : takenNanos;
    return due;
  }
}
