package tellosimulator.controller;

/**
 * The four values of {@code rc}, each from -100 to 100; the app's fast mode exceeds that.
 *
 * @param right positive to the right
 * @param forward positive along the nose
 * @param up positive upwards
 * @param clockwise positive clockwise seen from above
 */
public record Sticks(double right, double forward, double up, double clockwise) {

  public static final Sticks CENTERED = new Sticks(0, 0, 0, 0);

  public boolean centered() {
    return equals(CENTERED) || (right == 0 && forward == 0 && up == 0 && clockwise == 0);
  }
}
