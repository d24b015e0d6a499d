package tellosimulator.scenery.overlay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;

class HeadingRingTest {

  private static final double NEAR = 0.1;
  private static final Livery BLUE = new Livery(Rgb.WHITE, Rgb.of(0x0072b2));
  private static final Vec3 FORWARD = new Vec3(1, 0, 0);

  private final HeadingRing ring = new HeadingRing(BLUE, 1);

  @ParameterizedTest
  @ValueSource(doubles = {0, 60, -135})
  void itLiesLevelAndPointsWhereTheDroneLooksHoweverThatTilts(double headingDeg) {
    Attitude heading = Attitude.ofHeading(Math.toRadians(headingDeg));
    Attitude tilted = Attitude.tiltedTo(new Vec3(0.2, 0.1, 1).normalized()).after(heading);

    Attitude shown = instance(new Pose(Vec3.ZERO, heading), eye(-4, 4)).pose().attitude();
    assertThat(shown.toRoom(FORWARD).minus(heading.toRoom(FORWARD)).norm()).isLessThan(1e-9);

    Attitude level = instance(new Pose(Vec3.ZERO, tilted), eye(-4, 4)).pose().attitude();
    assertThat(level.up().z()).isCloseTo(1, within(1e-9));
    assertThat(level.heading()).isCloseTo(tilted.heading(), within(1e-9));
  }

  @Test
  void seenFromTheSideItLeansTowardsTheCamera() {
    for (Eye eye : new Eye[] {eye(-4, 0.02), eye(-4, 1), eye(-4, -2)}) {
      Pose drone = new Pose(new Vec3(0, 0, 1), Attitude.ofHeading(2));
      Vec3 towards = eye.pose().position().minus(drone.position()).normalized();

      // sin 30 degrees, seen from the same height
      assertThat(instance(drone, eye).pose().attitude().up().dot(towards))
          .isCloseTo(0.5, within(0.01));
    }
  }

  @ParameterizedTest
  @CsvSource({"4, 0.034", "12, 0.034"})
  void itHasTheSameSizeInThePictureFromEverywhere(double distance, double share) {
    Eye eye = eye(-distance, 0);
    Instance shown = instance(new Pose(Vec3.ZERO, Attitude.LEVEL), eye);

    double seenAt = shown.pose().position().distanceTo(eye.pose().position());
    assertThat(shown.largestScale() / seenAt).isCloseTo(share, within(1e-6));
    assertThat(seenAt)
        .as("in front of the room, but not of tags")
        .isBetween(2.9 * NEAR, 3.4 * NEAR);
  }

  @Test
  void amongManyItIsSmaller() {
    Pose drone = new Pose(Vec3.ZERO, Attitude.LEVEL);
    Eye eye = eye(-4, 4);
    Instance ofMany =
        new HeadingRing(BLUE, 20).around(drone, Emphasis.NORMAL, eye).orElseThrow().instance();

    // the sixth root of 20 is 1.65
    assertThat(instance(drone, eye).largestScale() / ofMany.largestScale())
        .isCloseTo(1.65, within(0.01));
  }

  @Test
  void thatOfTheChosenDroneIsLargerAndBolderAndInFrontOfOthers() {
    Pose drone = new Pose(Vec3.ZERO, Attitude.LEVEL);
    Eye eye = eye(-4, 4);
    OverlayItem chosenRing = ring.around(drone, Emphasis.STRONG, eye).orElseThrow();
    OverlayItem otherRing = ring.around(drone, Emphasis.FAINT, eye).orElseThrow();
    Instance chosen = chosenRing.instance();
    Instance other = otherRing.instance();

    assertThat(seen(chosen, eye) / seen(other, eye)).isCloseTo(1.4, within(1e-6));
    assertThat(chosenRing.distance()).isLessThan(otherRing.distance());
    assertThat(covered(chosen)).isGreaterThan(1.3 * covered(other));
  }

  /** Returns the apparent radius, as a share of the distance. */
  private static double seen(Instance ring, Eye eye) {
    return ring.largestScale() / ring.pose().position().distanceTo(eye.pose().position());
  }

  /** Returns the number of visible texels. */
  private static double covered(Instance ring) {
    return Arrays.stream(ring.part().material().texture().argbArray())
        .filter(argb -> argb >>> 24 > 127)
        .count();
  }

  @Test
  void aTagStandsClearOfTheArrowheadThatPointsAwayFromTheCamera() {
    Eye above = new Eye(new Pose(new Vec3(0, 0, 5), lookingDown()), NEAR);
    Pose away = new Pose(Vec3.ZERO, Attitude.LEVEL);
    Pose towards = new Pose(Vec3.ZERO, Attitude.ofHeading(Math.PI));

    // From above, a ring of 0.034 times 5 m, and an arrowhead of 1.9 radii upwards on the screen.
    assertThat(ring.reach(towards, Emphasis.NORMAL, above)).isCloseTo(0.17, within(1e-3));
    assertThat(ring.reach(away, Emphasis.NORMAL, above)).isCloseTo(1.9 * 0.17, within(1e-3));
    assertThat(ring.reach(away, Emphasis.NORMAL, eye(-1, 1))).as("without a ring").isZero();
  }

  private static Attitude lookingDown() {
    return new Attitude(Math.cos(Math.PI / 4), 0, Math.sin(Math.PI / 4), 0);
  }

  private Instance instance(Pose drone, Eye eye) {
    return ring.around(drone, Emphasis.NORMAL, eye).orElseThrow().instance();
  }

  private static Eye eye(double x, double z) {
    return new Eye(new Pose(new Vec3(x, 0, z), Attitude.LEVEL), NEAR);
  }
}
