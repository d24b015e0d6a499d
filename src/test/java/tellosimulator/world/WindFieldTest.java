package tellosimulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.time.SimTime;

class WindFieldTest {

  @Test
  void withoutGustsTheWindIsSteady() {
    Vec3 mean = new Vec3(1, -0.5, 0);
    WindField field = new WindField(new Wind(mean, 0), 1);

    assertThat(field.at(at(0))).isEqualTo(mean);
    assertThat(field.at(at(77))).isEqualTo(mean);
  }

  @Test
  void gustsHaveTheirMeanAndDeviation() {
    WindField field = new WindField(new Wind(new Vec3(1, 0, 0), 0.5), 4);
    double[] ahead =
        IntStream.range(0, 100_000).mapToDouble(i -> field.at(at(i * 0.1)).x()).toArray();

    double mean =
        IntStream.range(0, ahead.length).mapToDouble(i -> ahead[i]).average().orElseThrow();
    double variance =
        IntStream.range(0, ahead.length)
            .mapToDouble(i -> (ahead[i] - mean) * (ahead[i] - mean))
            .average()
            .orElseThrow();

    assertThat(mean).isCloseTo(1, within(0.02));
    assertThat(Math.sqrt(variance)).isCloseTo(0.5, within(0.02));
  }

  @Test
  void theSameSeedGivesTheSameGustsAndAnotherOneOthers() {
    Wind wind = new Wind(Vec3.ZERO, 1);
    Vec3 gust = new WindField(wind, 5).at(at(12.345));

    assertThat(new WindField(wind, 5).at(at(12.345))).isEqualTo(gust);
    assertThat(new WindField(wind, 6).at(at(12.345))).isNotEqualTo(gust);
    assertThat(gust.z()).as("gusts are level").isZero();
  }

  private static SimTime at(double seconds) {
    return new SimTime(Math.round(seconds * 1e9));
  }
}
