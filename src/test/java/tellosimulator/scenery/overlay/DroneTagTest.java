package tellosimulator.scenery.overlay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;

class DroneTagTest {

  private static final Eye EYE = new Eye(new Pose(new Vec3(-4, 0, 0), Attitude.LEVEL), 0.1);
  private static final Livery BLUE = new Livery(Rgb.WHITE, Rgb.of(0x0072b2));

  @ParameterizedTest
  @CsvSource({"2, STRONG, 1.3", "2, FAINT, 1", "8, FAINT, 1", "9, STRONG, 1.3", "9, FAINT, 0.7"})
  void thatOfTheChosenDroneIsLargerAndOthersOfManyAreSmaller(
      int drones, Emphasis emphasis, double factor) {
    assertThat(size(drones, emphasis) / size(drones, Emphasis.NORMAL))
        .isCloseTo(factor, within(1e-6));
  }

  @Test
  void thatOfTheChosenDroneIsInFrontOfThoseOfNearerOnes() {
    OverlayItem chosen = tag(2, Emphasis.STRONG, new Vec3(3, 0, 0));
    OverlayItem nearer = tag(2, Emphasis.FAINT, Vec3.ZERO);

    assertThat(chosen.distance()).isLessThan(nearer.distance());
    assertThat(fromEye(chosen.instance())).isLessThan(fromEye(nearer.instance()));
  }

  /** Returns the apparent edge, as a share of the distance. */
  private static double size(int drones, Emphasis emphasis) {
    Instance tag = tag(drones, emphasis, Vec3.ZERO).instance();
    return tag.largestScale() / fromEye(tag);
  }

  private static double fromEye(Instance tag) {
    return tag.pose().position().distanceTo(EYE.pose().position());
  }

  private static OverlayItem tag(int drones, Emphasis emphasis, Vec3 place) {
    return new DroneTag(1, BLUE, drones).above(new Pose(place, Attitude.LEVEL), 0, emphasis, EYE);
  }
}
