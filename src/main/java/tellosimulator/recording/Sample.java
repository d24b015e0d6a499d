package tellosimulator.recording;

import tellosimulator.math.Vec3;

/**
 * A row of {@code flight.csv}: a drone at a moment. Immutable; for any thread.
 *
 * @param time simulated seconds since the simulation began
 * @param position of its feet, room frame [m]
 * @param velocity room frame [m/s]
 * @param angles how it is turned
 * @param phase the word for what it is doing
 * @param batteryPercent 0 to 100
 * @param command the one that it carries out; empty if none
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
   * How a drone is turned, in degrees.
   *
   * @param roll right side down is positive
   * @param pitch nose up is positive
   * @param heading clockwise seen from above, 0 along the room's x axis
   */
  public record Angles(double roll, double pitch, double heading) {}
}
