package tellosimulator.view.controls;

/**
 * Which numbers a field or a slider takes. Immutable.
 *
 * @param least the smallest
 * @param most the largest, not below {@code least}
 * @param step by how much an arrow key changes the number
 */
public record NumberRange(double least, double most, double step) {

  public NumberRange {
    if (!(least <= most && step > 0)) {
      throw new IllegalArgumentException(
          "from " + least + " to " + most + " by " + step + " is no range");
    }
  }

  public boolean contains(double value) {
    return value >= least && value <= most;
  }

  /** The number of the range that is nearest. */
  public double nearest(double value) {
    return Math.max(least, Math.min(most, value));
  }

  /** The nearest multiple of the step, or the end of the range that was reached. */
  public double snapped(double value) {
    if (value <= least || value >= most) {
      return nearest(value);
    }
    return nearest(Math.round(value / step) * step);
  }

  /**
   * The multiple of the step that comes next.
   *
   * @param direction 1 for up, -1 for down
   */
  public double next(double value, int direction) {
    double steps = value / step;
    double next = direction > 0 ? Math.floor(steps + 1e-9) + 1 : Math.ceil(steps - 1e-9) - 1;
    return nearest(next * step);
  }
}
