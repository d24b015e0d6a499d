package tellosimulator.scenery.drone;

import tellosimulator.model.Battery;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;

/**
 * The state of the status light beside the camera.
 *
 * <p>Documented (Tello User Manual, "Aircraft Status Indicator"; not rechecked against the manual):
 * blinking green twice means that vision positioning works; blinking yellow quickly means that
 * there is no signal from a remote control; blinking red slowly means that the battery is low;
 * blinking red quickly means that the battery is critically low; steady red means that there is a
 * critical error. The light of a real drone therefore blinks on the ground, too; see {@link
 * #steady}. Assumed: the durations of the blinks.
 */
public enum StatusLight {
  /** The drone is off; the lamp is unlit. */
  DARK(Rgb.of(0x404040), new double[] {1}),
  /** No operator has sent a command yet. */
  WAITING(Rgb.of(0xffc400), new double[] {0.4, 0, 0.2}),
  /** An operator program sends commands. */
  READY(Rgb.of(0x25e05a), new double[] {1.4, 0, 0.15, 0.3, 0.45}),
  LOW_BATTERY(Rgb.of(0xff2b20), new double[] {1.2, 0, 0.6}),
  CRITICAL_BATTERY(Rgb.of(0xff2b20), new double[] {0.3, 0, 0.15}),
  FAILED(Rgb.of(0xff2b20), new double[] {1, 0});

  private final Rgb color;
  private final double[] pattern;

  /**
   * Creates a state of the light.
   *
   * @param color colour of the light while it is lit
   * @param pattern the period, then the times within a period at which the light goes on, off, on,
   *     off … [s]; all patterns begin lit, except the pattern of {@link #DARK}
   */
  StatusLight(Rgb color, double[] pattern) {
    this.color = color;
    this.pattern = pattern;
  }

  /**
   * Returns the visible state of a drone's light at the time of the drone's state; {@link #DARK}
   * between blinks.
   */
  public static StatusLight seen(DroneSnapshot drone) {
    StatusLight light = of(drone);
    return light.lit(drone.state().time().seconds()) ? light : DARK;
  }

  /**
   * Returns a copy of a drone on the ground, with its time set to a moment when the light is lit.
   * The drone then looks the same in every snapshot and need not be drawn again. Returns the drone
   * unchanged if it is moving, its board's lights are animated, or its status light warns and must
   * continue to blink.
   */
  public static DroneSnapshot steady(DroneSnapshot drone) {
    DroneState state = drone.state();
    boolean calm = of(drone) == WAITING || of(drone) == READY;
    boolean changes = state.phase().moving() || state.lights().animated();
    return calm && !changes ? drone.withState(state.at(SimTime.ZERO)) : drone;
  }

  private static StatusLight of(DroneSnapshot drone) {
    DroneState state = drone.state();
    return of(
        state.phase(), state.energy().battery().percent(), drone.link().operator().isPresent());
  }

  /** Returns the state of the light of a drone in the given condition. */
  static StatusLight of(FlightPhase phase, double batteryPercent, boolean commanded) {
    if (phase == FlightPhase.OFF) {
      return DARK;
    }
    if (phase == FlightPhase.CRASHED) {
      return FAILED;
    }
    if (batteryPercent <= Battery.LANDS_BY_ITSELF) {
      return CRITICAL_BATTERY;
    }
    if (batteryPercent <= Battery.TOO_LOW_FOR_TAKEOFF) {
      return LOW_BATTERY;
    }
    return commanded ? READY : WAITING;
  }

  /** Returns the colour of the light while it is lit. */
  Rgb color() {
    return color;
  }

  /**
   * Returns whether the light is lit at a given time.
   *
   * @param seconds time on any clock
   */
  boolean lit(double seconds) {
    double within = seconds - pattern[0] * Math.floor(seconds / pattern[0]);
    boolean lit = false;
    for (int i = 1; i < pattern.length && within >= pattern[i]; i++) {
      lit = i % 2 == 1;
    }
    return lit;
  }
}
