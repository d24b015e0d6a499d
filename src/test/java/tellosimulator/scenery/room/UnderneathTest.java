package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.room.Underneath.Place;
import tellosimulator.world.Arena;
import tellosimulator.world.Cover;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

class UnderneathTest {

  /** A table of 1 by 1 by 0.7 m in the middle of the room. */
  private static final Arena TABLE =
      Arena.DEFAULT.withObstacles(
          List.of(new Obstacle("table", new Shape.Box(1, 1, 0.7), Vec3.ZERO, 0, Cover.DEFAULT)));

  private final Underneath underneath = new Underneath();

  @Test
  void besideAnObstacleItIsTheFloor() {
    Vec3 beside = new Vec3(0.6, 0, 1.2);

    assertThat(underneath.of(TABLE, beside)).isEqualTo(new Place(0, Shadow.at(1.2).radius()));
    assertThat(underneath.of(Arena.DEFAULT, Vec3.ZERO)).isEqualTo(new Place(0, 0.15));
  }

  @Test
  void overAnObstacleItIsItsTop() {
    Place place = underneath.of(TABLE, new Vec3(0.1, 0.1, 1.2));

    assertThat(place.height()).isCloseTo(0.7, within(1e-9));
    assertThat(place.radius()).isCloseTo(Shadow.at(0.5).radius(), within(1e-9));
  }

  @Test
  void oneThatStandsOnAnObstacleCastsItsShadowThere() {
    assertThat(underneath.of(TABLE, new Vec3(0, 0, 0.7)).height()).isCloseTo(0.7, within(1e-9));
  }

  @Test
  void nearTheEdgeTheShadowDoesNotStandOut() {
    Place place = underneath.of(TABLE, new Vec3(0.44, 0, 0.9));

    assertThat(place.height()).isCloseTo(0.7, within(1e-9));
    assertThat(place.radius()).isBetween(0.02, 0.06);
  }

  @Test
  void underAnObstacleItIsTheFloor() {
    Arena shelf =
        TABLE.withObstacles(List.of(TABLE.obstacles().get(0).movedTo(new Vec3(0, 0, 1.5), 0)));

    assertThat(underneath.of(shelf, new Vec3(0, 0, 1)).height()).isZero();
  }
}
