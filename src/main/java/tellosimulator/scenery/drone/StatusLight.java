package tellosimulator.scenery.drone;

import tellosimulator.model.Battery;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;

/**
 * What the status light beside the camera shows.
 *
 * <p>Documented: Tello User Manual, "Aircraft Status Indicator", not read again for this: green,
 * blinking twice: vision positioning works; yellow, blinking quickly: no signal of a remote
 * control; red, blinking slowly: low battery; red, blinking quickly: critically low battery; red,
 * steady: critical error. So a real drone's light blinks while it stands, too; see {@link #steady}.
 * Assumed: the lengths of blinks.
 */
public enum StatusLight {
  /** Without power: the lamp itself. */
  DARK(Rgb.of(0x404040), new double[] {1}),
  /** Nobody has commanded yet. */
  WAITING(Rgb.of(0xffc400), new double[] {0.4, 0, 0.2}),
  /** An operator program commands. */
  READY(Rgb.of(0x25e05a), new double[] {1.4, 0, 0.15, 0.3, 0.45}),
  LOW_BATTERY(Rgb.of(0xff2b20), new double[] {1.2, 0, 0.6}),
  CRITICAL_BATTERY(Rgb.of(0xff2b20), new double[] {0.3, 0, 0.15}),
  FAILED(Rgb.of(0xff2b20), new double[] {1, 0});

  private final Rgb color;
  private final double[] pattern;

  /**
   * @param pattern its period, then when it goes on, off, on, off … within a period [s]; all but
   *     that of {@link #DARK} begin lit
   */
  StatusLight(Rgb color, double[] pattern) {
    this.color = color;
    this.pattern = pattern;
  }

  /** What one sees of a drone's light at the moment of its state, the blinking included. */
  public static StatusLight seen(DroneSnapshot drone) {
    StatusLight light = of(drone);
    return light.lit(drone.state().time().seconds()) ? light : DARK;
  }

  /**
   * A drone that stands, at a moment at which its light is lit, for pictures that are drawn as
   * seldom as possible; the drone itself if its light warns, which goes on blinking.
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

  /** What the light of a drone shows. */
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

  /** Its colour while it is lit. */
  Rgb color() {
    return color;
  }

  /**
   * Whether it is lit at a moment.
   *
   * @param seconds on any clock
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
