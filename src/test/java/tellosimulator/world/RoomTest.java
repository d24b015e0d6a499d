package tellosimulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.math.Vec3;

class RoomTest {

  /** 4 m wide (y), 6 m deep (x), 3 m high. */
  private static final Room ROOM = new Room(4, 6, 3);

  /** With this collider positions inside are x within 2.75, y within 1.75 and z from 0 to 2.5. */
  private static final Collider COLLIDER = new Collider(0.25, 0.5);

  @ParameterizedTest
  @CsvSource({"0,0,0", "2.75,0,1", "-2.75,1.75,2.5", "0,-1.75,0", "1,1,1"})
  void nothingStopsABodyInside(double x, double y, double z) {
    Vec3 position = new Vec3(x, y, z);

    assertThat(ROOM.contains(position, COLLIDER)).isTrue();
    assertThat(ROOM.nearestInside(position, COLLIDER)).isEqualTo(position);
    assertThat(ROOM.collide(position, new Vec3(9, 9, 9), COLLIDER)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          # position,  velocity,  surface,    normal,  speed, held at,   velocity left
          3 0 1,       2 1 0,     FRONT_WALL, -1 0 0,  2,     2.75 0 1,  0 1 0
          -3 0 1,      -2 1 0,    BACK_WALL,  1 0 0,   2,     -2.75 0 1, 0 1 0
          0 2 1,       1 0.5 0,   LEFT_WALL,  0 -1 0,  0.5,   0 1.75 1,  1 0 0
          0 -2 1,      0 -3 0,    RIGHT_WALL, 0 1 0,   3,     0 -1.75 1, 0 0 0
          0 0 -0.01,   1 0 -0.4,  FLOOR,      0 0 1,   0.4,   0 0 0,     1 0 0
          0 0 2.6,     0 0 1,     CEILING,    0 0 -1,  1,     0 0 2.5,   0 0 0
          # In a corner the surface is the one that was hit fastest; both take their share.
          3 2 1,       1 2 0.5,   LEFT_WALL,  0 -1 0,  2,     2.75 1.75 1, 0 0 0.5
          3 2 1,       2 1 0,     FRONT_WALL, -1 0 0,  2,     2.75 1.75 1, 0 0 0
          -3 0 -1,     -1 0 -5,   FLOOR,      0 0 1,   5,     -2.75 0 0, 0 0 0
          # A body that already leaves a surface keeps its velocity.
          3 0 1,       -2 0 0,    FRONT_WALL, -1 0 0,  0,     2.75 0 1,  -2 0 0
          3 0 1,       0 0 0,     FRONT_WALL, -1 0 0,  0,     2.75 0 1,  0 0 0
          """)
  void aSurfaceStopsABodyAndLetsItSlide(
      String position,
      String velocity,
      Surface surface,
      String normal,
      double speed,
      String held,
      String left) {
    Collision collision = ROOM.collide(vec(position), vec(velocity), COLLIDER).orElseThrow();

    assertThat(collision.touched()).isEqualTo(surface);
    assertThat(collision.normal().distanceTo(vec(normal))).isZero();
    assertThat(collision.speed()).isEqualTo(speed);
    assertThat(collision.position()).isEqualTo(vec(held));
    assertThat(collision.velocity().distanceTo(vec(left))).isZero();
    assertThat(ROOM.contains(collision.position(), COLLIDER)).isTrue();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.99, 200.1, -3, 0, Double.NaN, Double.POSITIVE_INFINITY})
  void edgesAreLimited(double edge) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Room(5, 5, edge))
        .withMessage("room height is " + edge + " m, but must be from 1.0 to 200.0");
    assertThatIllegalArgumentException().isThrownBy(() -> new Room(edge, 5, 3));
    assertThatIllegalArgumentException().isThrownBy(() -> new Room(5, edge, 3));
  }

  @Test
  void theDefaultIsFiveByFiveByThreeMeters() {
    assertThat(Room.DEFAULT).isEqualTo(new Room(5, 5, 3));
  }

  private static Vec3 vec(String words) {
    String[] numbers = words.split(" ", -1);
    return new Vec3(
        Double.parseDouble(numbers[0]),
        Double.parseDouble(numbers[1]),
        Double.parseDouble(numbers[2]));
  }
}
