package tellosimulator.protocol.app;

import tellosimulator.controller.Sticks;

/**
 * The limits that the app sets. They act on its sticks. A loss of power restores them. Confined to
 * the simulation thread.
 */
final class AppLimits {

  /** Height limit of a new drone [m]. Documented: Tello User Manual, the app's default. */
  private static final int HEIGHT = 30;

  /** Attitude limit of a new drone [degrees]. Measured: TelloLib, SMerrony/tello. */
  private static final float ATTITUDE = 25;

  /** Charge at which the battery counts as low [%]. Measured: an answer in a log of TelloPy. */
  private static final int LOW_BATTERY = 20;

  /** Distance below the height limit at which a climb begins to slow down [m]. Decided. */
  private static final double BRAKING = 1.5;

  /** A full stick. */
  private static final double FULL = 100;

  private int height = HEIGHT;
  private float attitude = ATTITUDE;
  private int lowBattery = LOW_BATTERY;

  void reset() {
    height = HEIGHT;
    attitude = ATTITUDE;
    lowBattery = LOW_BATTERY;
  }

  /** Returns the height limit above the floor [m]. */
  int height() {
    return height;
  }

  /** Sets the height limit; returns false if it is out of range. */
  boolean setHeight(int meters) {
    boolean valid = meters >= 1 && meters <= HEIGHT;
    height = valid ? meters : height;
    return valid;
  }

  /** Returns the attitude limit [degrees]. */
  float attitude() {
    return attitude;
  }

  /** Sets the attitude limit; returns false if it is out of range. */
  boolean setAttitude(float degrees) {
    boolean valid = degrees > 0 && degrees <= ATTITUDE;
    attitude = valid ? degrees : attitude;
    return valid;
  }

  /** Returns the charge at which the battery counts as low [%]. */
  int lowBattery() {
    return lowBattery;
  }

  /** Sets the charge at which the battery counts as low; returns false if it is out of range. */
  boolean setLowBattery(int percent) {
    boolean valid = percent >= 0 && percent <= 100;
    lowBattery = valid ? percent : lowBattery;
    return valid;
  }

  /** Whether a climb must slow down at a height [m]. */
  boolean near(double meters) {
    return meters > height - BRAKING;
  }

  /**
   * Returns sticks that respect the limits. Decided: speeds are proportional to the attitude.
   *
   * @param meters the height of the drone above the floor [m]
   */
  Sticks limited(Sticks sticks, double meters) {
    double part = attitude / ATTITUDE;
    double fastest = Math.max(0, FULL * (height - meters) / BRAKING);
    double up = Math.min(fastest, sticks.up());
    return new Sticks(part * sticks.right(), part * sticks.forward(), up, sticks.clockwise());
  }
}
