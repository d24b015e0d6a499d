package tellosimulator.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.world.Room;

class FormationTest {

  private static final double TINY = 1e-12;

  @Test
  void oneDroneStandsInTheMiddleAndLooksAlongX() {
    Vec3 middle = new Vec3(1, -0.5, 0);

    assertThat(Formation.row(1, middle, Room.DEFAULT))
        .containsExactly(new Pose(middle, Attitude.LEVEL));
  }

  @Test
  void neighborsAre60CentimetersApartTheFirstOneAtTheLeft() {
    List<Pose> starts = Formation.row(3, Vec3.ZERO, Room.DEFAULT);

    assertThat(starts).extracting(start -> start.position().y()).containsExactly(0.6, 0.0, -0.6);
    assertThat(starts).extracting(start -> start.position().x()).containsOnly(0.0);
  }

  @Test
  void anEvenNumberStandsAroundTheMiddle() {
    List<Pose> starts = Formation.row(2, Vec3.ZERO, Room.DEFAULT);

    assertThat(starts.get(0).position().y()).isCloseTo(0.3, within(TINY));
    assertThat(starts.get(1).position().y()).isCloseTo(-0.3, within(TINY));
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # Free width 5 - 2 * 0.087 = 4.826 m, 8 gaps of 0.6 m: 9 drones a row.
          9,  1
          10, 2
          18, 2
          19, 3
          """)
  void whatDoesNotFitBesideStandsBehind(int drones, int rows) {
    List<Pose> starts = Formation.row(drones, Vec3.ZERO, Room.DEFAULT);

    assertThat(starts).hasSize(drones);
    assertThat(starts.stream().map(start -> start.position().x()).distinct()).hasSize(rows);
    assertThat(starts)
        .allMatch(start -> Room.DEFAULT.contains(start.position(), DroneSpec.COLLIDER));
    for (int i = 0; i < drones; i++) {
      for (int k = 0; k < i; k++) {
        assertThat(starts.get(i).position().distanceTo(starts.get(k).position()))
            .isGreaterThan(0.6 - TINY);
      }
    }
  }

  @Test
  void tooManyAreRefusedWithThePlaceThatIsOutside() {
    // Rows of 9 at x 0, -0.6, -1.2, -1.8 and -2.4, which is 10 cm from the wall; the collider has
    // 8.7.
    assertThat(Formation.row(45, Vec3.ZERO, Room.DEFAULT)).hasSize(45);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Formation.row(46, Vec3.ZERO, Room.DEFAULT))
        .withMessage("drone 46 does not fit into the room: its start would be at x -300, y 0 cm");
  }

  @Test
  void aStartOutsideTheRoomIsRefused() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Formation.row(1, new Vec3(0, 3, 0), Room.DEFAULT))
        .withMessage("drone 1 does not fit into the room: its start would be at x 0, y 300 cm");
  }
}
