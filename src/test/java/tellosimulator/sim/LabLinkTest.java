package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.testing.SteppedDrone.Sent;

/**
 * Behaviour {@code measured} has the link of a real drone: TelloPy 0.7.0, docs/sensor_time.md,
 * measured in September 2026 with one drone.
 */
@Tag("slow")
class LabLinkTest {

  /** An operator that receives state lines no matter how long it is silent. */
  private static final InetSocketAddress NEIGHBOR = SteppedDrone.address("127.0.0.1", 9000);

  private static final int QUERIES = 10_000;

  private final SteppedDrone drone =
      SteppedDrone.of(SimConfig.DEFAULT.withProduct(Profile.EDU, Behavior.MEASURED));

  @Test
  void queriesTakeAsLongAsMeasured() {
    connect();
    List<Double> times = new ArrayList<>();
    for (int i = 0; i < QUERIES; i++) {
      int before = drone.replies().size();
      double asked = drone.seconds();
      drone.send(NEIGHBOR, "battery?");
      if (drone.advanceUntil(() -> drone.replies().size() > before, 0.3)) {
        times.add((drone.seconds() - asked) * 1000);
      }
    }
    Collections.sort(times);

    assertThat(times.get(0)).as("min").isCloseTo(5, withinPercentage(10));
    assertThat(quantile(times, 0.5)).as("median").isCloseTo(44, withinPercentage(10));
    assertThat(times.stream().mapToDouble(time -> time).average().orElseThrow())
        .as("mean")
        .isCloseTo(53, withinPercentage(10));
    assertThat(quantile(times, 0.95)).as("95th").isCloseTo(124, withinPercentage(10));
    assertThat(quantile(times, 0.99)).as("99th").isBetween(170.0, 200.0);
    assertThat(times.get(times.size() - 1)).as("max").isCloseTo(228, withinPercentage(10));
    assertThat((QUERIES - times.size()) / (double) QUERIES)
        .as("never answered")
        .isBetween(0.015, 0.025);
  }

  private static double quantile(List<Double> sorted, double part) {
    return sorted.get((int) (part * sorted.size()));
  }

  @Test
  void stateLinesScatterAndAreMissingAsMeasured() {
    connect();
    int before = drone.stateLines().size();
    drone.advance(600);

    List<Sent> lines = drone.stateLines().subList(before, drone.stateLines().size());
    assertThat(lines.size() / 5964.0).as("of 600 s / 100.6 ms").isBetween(0.85, 0.94);
    List<Double> steps = new ArrayList<>();
    for (int i = 1; i < lines.size(); i++) {
      steps.add((lines.get(i).seconds() - lines.get(i - 1).seconds()) * 1000);
    }
    double longest = Collections.max(steps);
    assertThat(longest).as("gaps").isBetween(400.0, 900.0);
    List<Double> next = steps.stream().filter(step -> step < 150).toList();
    double mean = next.stream().mapToDouble(step -> step).average().orElseThrow();
    double variance =
        next.stream().mapToDouble(step -> (step - mean) * (step - mean)).average().orElseThrow();
    assertThat(StrictMath.sqrt(variance)).as("scatter").isBetween(20.0, 35.0);
  }

  private void connect() {
    while (drone.replies().isEmpty()) {
      drone.send(NEIGHBOR, "command");
      drone.advance(0.3);
    }
  }
}
