package tellosimulator.scenery.overlay;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;

class FlightPathsTest {

  private final FlightPaths paths = new FlightPaths(16);

  @Test
  void aTakeoffBeginsANewPathAndKeepsTheOneBefore() {
    fly(1);
    assertThat(paths.earlier()).as("the first flight").isEmpty();
    FlightPath first = paths.present();

    assertThat(paths.earlier()).as("landed, until the next takeoff").isEmpty();
    int before = paths.changes();
    fly(2);

    assertThat(paths.earlier()).containsExactly(first);
    assertThat(paths.present()).isNotSameAs(first);
    assertThat(paths.present().point(paths.present().size() - 1)).isEqualTo(new Vec3(0, 0, 2));
    assertThat(paths.changes()).isNotEqualTo(before);
  }

  @Test
  void noMoreThanTheLastFlightsAreKept() {
    for (int i = 1; i <= FlightPaths.EARLIER + 3; i++) {
      fly(i);
    }

    assertThat(paths.earlier()).hasSize(FlightPaths.EARLIER);
    assertThat(top(paths.earlier().get(0))).as("newest first").isEqualTo(FlightPaths.EARLIER + 2);
    assertThat(top(paths.earlier().get(FlightPaths.EARLIER - 1))).isEqualTo(3);
  }

  @Test
  void olderPathsAreFainterButCanBeSeen() {
    for (int age = 2; age <= FlightPaths.EARLIER; age++) {
      assertThat(FlightPaths.opacity(age)).isLessThan(FlightPaths.opacity(age - 1));
    }
    assertThat(FlightPaths.opacity(1)).isLessThan(0.5);
    assertThat(FlightPaths.opacity(FlightPaths.EARLIER)).isGreaterThan(0.1);
  }

  @Test
  void aResetForgetsAll() {
    fly(1);
    fly(2);

    paths.clear();

    assertThat(paths.earlier()).isEmpty();
    assertThat(paths.present().size()).isZero();
  }

  /** Flies up from the floor and down again. */
  private void fly(double height) {
    paths.advance(false, new Vec3(0, 0, 0));
    paths.advance(true, new Vec3(0, 0, 0));
    paths.advance(true, new Vec3(0, 0, height / 2));
    paths.advance(false, new Vec3(0, 0, height));
  }

  private static double top(FlightPath path) {
    return IntStream.range(0, path.size()).mapToDouble(i -> path.point(i).z()).max().orElseThrow();
  }
}
