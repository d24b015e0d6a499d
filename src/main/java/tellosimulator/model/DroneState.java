package tellosimulator.model;

import tellosimulator.board.BoardLights;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.time.SimTime;

/**
 * A drone at a moment. Immutable; for any thread.
 *
 * @param drone its number, from 1
 * @param time the end of the step that made it
 * @param motion position, velocity and attitude
 * @param phase what it is doing
 * @param energy battery, temperature, motor time
 * @param reference what its instruments count from
 * @param perception of what is around it
 * @param video what was asked of the video
 * @param lights of the extension board, dark if it has none
 */
public record DroneState(
    int drone,
    SimTime time,
    Motion motion,
    FlightPhase phase,
    Energy energy,
    Reference reference,
    Perception perception,
    VideoSettings video,
    BoardLights lights) {

  /** Without lights. */
  public DroneState(
      int drone,
      SimTime time,
      Motion motion,
      FlightPhase phase,
      Energy energy,
      Reference reference,
      Perception perception,
      VideoSettings video) {
    this(drone, time, motion, phase, energy, reference, perception, video, BoardLights.DARK);
  }

  /** The same drone, moving otherwise. */
  public DroneState withMotion(Motion newMotion) {
    return new DroneState(
        drone, time, newMotion, phase, energy, reference, perception, video, lights);
  }

  /** The same drone at another moment. */
  public DroneState at(SimTime newTime) {
    return new DroneState(
        drone, newTime, motion, phase, energy, reference, perception, video, lights);
  }

  /**
   * What flying uses up.
   *
   * @param temperature of the electronics [°C]
   * @param motorTime motors on since power-on [s]
   */
  public record Energy(Battery battery, double temperature, double motorTime) {}

  /**
   * What instruments count from.
   *
   * @param poweredAt when the power came
   * @param heading at power-on or reset [rad]; yaw and velocity count from it
   * @param takeoffs since power-on
   * @param height of the feet at power-on, at reset or at the last takeoff, the latest of these
   *     [m]; {@code h} counts from it
   */
  public record Reference(SimTime poweredAt, double heading, int takeoffs, double height) {

    /** Where the nose points for the drone itself, counter-clockwise, within ±π [rad]. */
    public double turned(Attitude attitude) {
      return Frames.wrapped(attitude.heading() - heading);
    }
  }
}
