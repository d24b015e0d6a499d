package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.testing.SteppedDrone;

class StatusLightTest {

  private final SteppedDrone drone = SteppedDrone.of(SimConfig.DEFAULT);

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          OFF,       100, false, DARK
          OFF,       3,   true,  DARK
          GROUNDED,  100, false, WAITING
          GROUNDED,  100, true,  READY
          FLYING,    11,  true,  READY
          FLYING,    10,  true,  LOW_BATTERY
          GROUNDED,  10,  false, LOW_BATTERY
          LANDING,   5,   true,  CRITICAL_BATTERY
          CRASHED,   100, true,  FAILED
          """)
  void itShowsWhatTheDroneDoes(
      FlightPhase phase, double battery, boolean commanded, StatusLight expected) {
    assertThat(StatusLight.of(phase, battery, commanded)).isEqualTo(expected);
  }

  @Test
  void readyBlinksTwiceInEachPeriod() {
    assertThat(flashes(StatusLight.READY, 1.4)).isEqualTo(2);
  }

  @Test
  void aCriticalBatteryBlinksFasterThanALowOne() {
    assertThat(flashes(StatusLight.CRITICAL_BATTERY, 6))
        .isGreaterThan(3 * flashes(StatusLight.LOW_BATTERY, 6));
  }

  @Test
  void afterACrashItIsSteadyAndWithoutPowerDark() {
    assertThat(litParts(StatusLight.FAILED)).isEqualTo(1000);
    assertThat(litParts(StatusLight.DARK)).isZero();
  }

  @Test
  void oneSeesItsColorOrBetweenTwoBlinksNone() {
    drone.control(new Control.Power(1, true));

    assertThat(seen(false)).containsExactlyInAnyOrder(StatusLight.WAITING, StatusLight.DARK);
  }

  @Test
  void whereItIsDrawnSeldomItIsSteady() {
    drone.control(new Control.Power(1, true));
    assertThat(seen(true)).containsExactly(StatusLight.WAITING);

    drone.ask("command");
    assertThat(seen(true)).containsExactly(StatusLight.READY);
  }

  @Test
  void aWarningBlinksEvenThere() {
    drone.control(new Control.Power(1, true));
    drone.control(new Control.SetBattery(1, 8));

    assertThat(seen(true)).containsExactlyInAnyOrder(StatusLight.LOW_BATTERY, StatusLight.DARK);
  }

  @Test
  void thePropellersOfAPausedDroneStayWhereTheyAre() {
    drone.control(new Control.Power(1, true));
    drone.ask("command");
    drone.ask("takeoff");

    assertThat(StatusLight.steady(drone.snapshot())).isEqualTo(drone.snapshot());
  }

  /** Returns the visible states within two seconds. */
  private Set<StatusLight> seen(boolean steady) {
    Set<StatusLight> seen = EnumSet.noneOf(StatusLight.class);
    for (int i = 0; i < 40; i++) {
      drone.advance(0.05);
      DroneSnapshot shown = drone.snapshot();
      seen.add(StatusLight.seen(steady ? StatusLight.steady(shown) : shown));
    }
    return seen;
  }

  private static long flashes(StatusLight light, double seconds) {
    int parts = (int) Math.round(seconds * 1000);
    return IntStream.range(0, parts)
        .filter(i -> light.lit((i + 0.5) / 1000) && !light.lit((i - 0.5) / 1000))
        .count();
  }

  private static long litParts(StatusLight light) {
    return IntStream.range(0, 1000).filter(i -> light.lit(i / 1000.0)).count();
  }
}
