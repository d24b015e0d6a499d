package tellosimulator.sensor;

import tellosimulator.math.Vec3;

/**
 * What the drone's instruments say, in the units and with the resolution that they have.
 *
 * @param attitude in degrees
 * @param velocityDm x along the heading at power-on, y to the right of it, z down [dm/s]
 * @param range what the distance and height sensors say
 * @param barometer height by air pressure [m], with an offset of its own
 * @param acceleration felt, x forward, y right, z down [0.001 g]
 * @param health battery, temperature and time
 */
public record SensorReadings(
    AttitudeDeg attitude,
    Vec3 velocityDm,
    Range range,
    double barometer,
    Vec3 acceleration,
    Health health) {

  /**
   * Attitude in whole degrees.
   *
   * @param pitch nose down is negative
   * @param roll right side down is positive
   * @param yaw clockwise is positive, from the heading at power-on, -179 to 180
   */
  public record AttitudeDeg(int pitch, int roll, int yaw) {}

  /**
   * Distances from the ground.
   *
   * @param tofMm distance to what is below [mm]; {@link TimeOfFlight#NONE_MM} without an echo
   * @param heightDm height above the place of the last takeoff [dm]
   */
  public record Range(int tofMm, int heightDm) {}

  /**
   * How the drone fares.
   *
   * @param batteryPercent 0 to 100
   * @param temperature the lower of the two reported ones [°C]
   * @param motorSeconds motors on since power-on
   */
  public record Health(int batteryPercent, int temperature, int motorSeconds) {

    /** The higher temperature is reported a few degrees above the lower one. Measured: 2 to 3. */
    public int highTemperature() {
      return temperature + 3;
    }
  }
}
