package tellosimulator.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.UnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.model.Motion;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.testing.SteppedDrone;
import tellosimulator.time.SimTime;

class InstrumentsTest {

  private static final Echoes NOTHING =
      new Echoes() {
        @Override
        public double below(Pose drone) {
          return 1;
        }

        @Override
        public double along(Vec3 origin, Vec3 direction) {
          return Double.POSITIVE_INFINITY;
        }
      };

  private final DroneState still = SteppedDrone.of(Profile.EDU, Behavior.REPORT).state();

  /** Returns the forward speeds read at 1,000 moments [dm/s]. */
  private double[] speeds(Behavior behavior, double metersPerSecond) {
    Instruments instruments =
        new Instruments(behavior, new SeededNoise(1, 1), NOTHING, UnaryOperator.identity());
    Motion rest = Motion.restingAt(new Pose(Vec3.ZERO, Attitude.LEVEL));
    DroneState moving = still.withMotion(rest.heldAt(Vec3.ZERO, new Vec3(metersPerSecond, 0, 0)));
    return IntStream.range(0, 1000)
        .mapToObj(i -> instruments.read(moving.at(new SimTime(i * 100_000_000L))))
        .mapToDouble(readings -> readings.velocityDm().x())
        .toArray();
  }

  @Test
  void speedsAreExactAfterTheReport() {
    assertThat(speeds(Behavior.REPORT, 0.25)).containsOnly(2.5);
  }

  /**
   * 2.5 dm/s with a noise of 0.4: one in ten is below 2 and one in ten is 3 or more, so that the
   * mean of the truncated values is 2.0. Rounded, it would be 2.5.
   */
  @Test
  void speedsAreCutOffToWholeDecimetersAsMeasured() {
    double[] speeds = speeds(Behavior.MEASURED, 0.25);

    assertThat(speeds).contains(1, 2, 3);
    assertThat(DoubleStream.of(speeds)).allMatch(speed -> speed == Math.rint(speed));
    assertThat(IntStream.range(0, 1000).mapToDouble(i -> speeds[i]).average().orElseThrow())
        .isCloseTo(2.0, within(0.1));
  }
}
