package tellosimulator.recording;

import tellosimulator.math.Vec3;

/**
 * A row of {@code flight.csv}: the state of a drone at one point in time. Immutable.
 *
 * @param time simulated seconds since the simulation began
 * @param position position of the drone's feet, in the room frame [m]
 * @param velocity velocity, in the room frame [m/s]
 * @param angles the drone's attitude
 * @param phase the word for the flight phase
 * @param batteryPercent charge of the battery, from 0 to 100 [%]
 * @param command the current command; empty if there is none
 */
public record Sample(
    double time,
    Vec3 position,
    Vec3 velocity,
    Angles angles,
    String phase,
    double batteryPercent,
    String command) {

  /**
   * The attitude of a drone, in degrees.
   *
   * @param roll positive when the right side is down
   * @param pitch positive when the nose is up
   * @param heading direction of the nose, clockwise seen from above; 0 is along the room's x axis
   */
  public record Angles(double roll, double pitch, double heading) {}
}
