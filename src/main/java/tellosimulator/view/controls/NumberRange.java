package tellosimulator.view.controls;

import tellosimulator.scenario.Quantity;

/**
 * The valid numbers of a field or a slider. Immutable.
 *
 * @param least the minimum
 * @param most the maximum, not less than {@code least}
 * @param step the amount by which an arrow key changes the number
 */
public record NumberRange(double least, double most, double step) {

  public NumberRange {
    if (!(least <= most && step > 0)) {
      throw new IllegalArgumentException(
          "from " + least + " to " + most + " by " + step + " is no range");
    }
  }

  /** Creates the range of a quantity, in the unit that scenario files use. */
  public NumberRange(Quantity quantity, double step) {
    this(quantity.least(), quantity.most(), step);
  }

  public boolean contains(double value) {
    return value >= least && value <= most;
  }

  /** Returns a value after limiting it to the range. */
  public double nearest(double value) {
    return Math.max(least, Math.min(most, value));
  }

  /**
   * Returns the nearest multiple of the step. A value at or beyond an end of the range gives that
   * end.
   */
  public double snapped(double value) {
    if (value <= least || value >= most) {
      return nearest(value);
    }
    return nearest(Math.round(value / step) * step);
  }

  /**
   * Returns the next multiple of the step, limited to the range.
   *
   * @param direction 1 for up, -1 for down
   */
  public double next(double value, int direction) {
    double steps = value / step;
    double next = direction > 0 ? Math.floor(steps + 1e-9) + 1 : Math.ceil(steps - 1e-9) - 1;
    return nearest(next * step);
  }
}
