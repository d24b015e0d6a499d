package tellosimulator.model;

import tellosimulator.extension.BoardLights;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.time.SimTime;

/**
 * The state of a drone at one moment. Immutable.
 *
 * @param drone the number of the drone, from 1
 * @param time the end of the step that produced the state
 * @param motion position, velocity and attitude
 * @param phase the flight phase
 * @param energy battery, temperature, motor time
 * @param reference the reference of the drone's instruments
 * @param perception the drone's perception of mission pads
 * @param video the settings of the video
 * @param lights the lights of the extension board; dark if the drone has no board
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

  /** Creates a state without lights. */
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

  /** Returns a copy with another motion. */
  public DroneState withMotion(Motion newMotion) {
    return new DroneState(
        drone, time, newMotion, phase, energy, reference, perception, video, lights);
  }

  /** Returns a copy with another time. */
  public DroneState at(SimTime newTime) {
    return new DroneState(
        drone, newTime, motion, phase, energy, reference, perception, video, lights);
  }

  /**
   * The energy-related state.
   *
   * @param temperature the temperature of the electronics [°C]
   * @param motorTime the time with motors on since power-on [s]
   */
  public record Energy(Battery battery, double temperature, double motorTime) {}

  /**
   * The reference of the instruments.
   *
   * @param poweredAt the time of power-on
   * @param heading the heading at power-on or reset [rad]: the zero of yaw, and the x axis of the
   *     reported velocity
   * @param takeoffs the number of takeoffs since power-on
   * @param height the height of the feet at power-on, reset or takeoff, whichever was last [m]; the
   *     zero of {@code h}
   */
  public record Reference(SimTime poweredAt, double heading, int takeoffs, double height) {

    /** Returns the heading relative to the reference, counter-clockwise, within ±π [rad]. */
    public double turned(Attitude attitude) {
      return Frames.wrapped(attitude.heading() - heading);
    }
  }
}
