package tellosimulator.goal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.goal.PlacedGoal.Square;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.world.Poster;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

class FrontViewTest {

  /** A poster of 30 cm, 50 cm above the floor, 2.5 m in front of the room's middle. */
  private static final Square POSTER =
      new Square(new Poster(Surface.FRONT_WALL, 0, 0.5, 0.3, "a.png").pose(Room.DEFAULT), 0.3);

  /**
   * The camera is 2 m in front of the wall and 2 tan 15° = 0.536 m above the poster's middle. Its
   * upper edge is 0.386 m below the camera: at the depth of 2 cos 15° + 0.386 sin 15° = 2.032 m.
   * The picture is 2 tan 27.5° · 2.032 = 2.115 m wide there: 0.3 / 2.115 = 14.2 percent.
   */
  private static final Vec3 IN_FRONT = new Vec3(0.5 - 0.035, 0, 0.5 + 0.536 - 0.0185);

  @Test
  void aPosterInTheMiddleOfThePictureIsAsLargeAsItsUpperEdge() {
    assertThat(percent(IN_FRONT, 0)).isCloseTo(14.18, within(0.02));
  }

  /** From 3 m: 0.804 m above the middle, depth 3 cos 15° + 0.654 sin 15° = 3.067 m: 9.4 percent. */
  @Test
  void fromFartherAwayItIsSmaller() {
    assertThat(percent(new Vec3(-0.535, 0, 0.5 + 0.804 - 0.0185), 0)).isCloseTo(9.39, within(0.02));
  }

  /** Half the picture is 27.5° wide and 21.3° high; half the poster takes 4.2° of each. */
  @ParameterizedTest
  @CsvSource({"0, true", "20, true", "-20, true", "26, false", "-26, false", "180, false"})
  void allOfItMustBeInThePicture(double headingDeg, boolean seen) {
    assertThat(percent(IN_FRONT, headingDeg) > 0).isEqualTo(seen);
  }

  @ParameterizedTest
  @CsvSource({"0.3, true", "-0.2, true", "0.9, false", "-0.8, false"})
  void itLeavesThePictureUpwardsAndDownwards(double higher, boolean seen) {
    assertThat(percent(IN_FRONT.plusScaled(Vec3.UP, higher), 0) > 0).isEqualTo(seen);
  }

  /** From 60° aside and equally far, it is about half as wide. */
  @Test
  void fromTheSideItIsNarrow() {
    Vec3 aside = new Vec3(2.5 - 2 * 0.5, 2 * 0.866, IN_FRONT.z());

    assertThat(percent(aside, -60)).isCloseTo(14.18 / 2, within(0.6));
  }

  @Test
  void theDistanceForASizeIsThatOfTheSquareInFrontOfTheCamera() {
    // 2 tan 27.5° = 1.0411: at 2.882 m the picture is 3 m wide
    assertThat(FrontView.distance(0.3, 10)).isCloseTo(2.882, within(0.001));
  }

  private static double percent(Vec3 feet, double headingDeg) {
    Pose drone = new Pose(feet, Attitude.ofHeading(Math.toRadians(headingDeg)));
    return FrontView.of(drone).percent(POSTER);
  }
}
