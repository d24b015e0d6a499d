package tellosimulator.sensor;

import tellosimulator.math.Vec3;

/**
 * The readings of a drone's instruments, in the units and resolution of the drone.
 *
 * @param attitude the attitude [degrees]
 * @param velocityDm the velocity [dm/s]: x along the heading at power-on, y to the right of that
 *     heading, z down
 * @param range the readings of the distance and height sensors
 * @param barometer the height according to air pressure [m], with a constant offset
 * @param acceleration the acceleration as an accelerometer measures it [0.001 g]: x forward, y
 *     right, z down
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
   * An attitude in whole degrees.
   *
   * @param pitch negative when the nose is down
   * @param roll positive when the right side is down
   * @param yaw positive clockwise, relative to the heading at power-on, from -179 to 180
   */
  public record AttitudeDeg(int pitch, int roll, int yaw) {}

  /**
   * The readings of the distance and height sensors.
   *
   * @param tofMm the distance to the object below [mm]; {@link TimeOfFlight#NONE_MM} without an
   *     echo
   * @param heightDm the height above the place of the last takeoff [dm]
   */
  public record Range(int tofMm, int heightDm) {}

  /**
   * The condition of the drone.
   *
   * @param batteryPercent 0 to 100
   * @param temperature the lower of the two reported temperatures [°C]
   * @param motorSeconds the time with motors on since power-on
   */
  public record Health(int batteryPercent, int temperature, int motorSeconds) {

    /**
     * Returns the higher temperature, a few degrees above the lower one [°C]. Measured: the
     * difference is 2 to 3.
     */
    public int highTemperature() {
      return temperature + 3;
    }
  }
}
