package tellosimulator.view.controls;

/** Round numbers for axis labels: 1, 2 or 5 times a power of ten. */
final class NiceNumber {

  private static final double[] MANTISSAS = {1, 2, 5, 10};

  private NiceNumber() {}

  /**
   * Returns the smallest round number that is not less than {@code value}; 1 if {@code value} is
   * not positive.
   */
  static double atLeast(double value) {
    if (!(value > 0)) {
      return 1;
    }
    double power = Math.pow(10, Math.floor(Math.log10(value)));
    for (double mantissa : MANTISSAS) {
      if (mantissa * power >= value * (1 - 1e-9)) {
        return mantissa * power;
      }
    }
    return 10 * power;
  }
}
