package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.room.BlobShadow.Shadow;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Shape;

class BlobShadowTest {

  /** A table of 1 by 1 by 0.7 m in the middle of the room. */
  private static final Arena TABLE =
      Arena.DEFAULT.withObstacles(
          List.of(
              new Obstacle(
                  "table", new Shape.Box(1, 1, 0.7), Vec3.ZERO, 0, ObstacleAppearance.DEFAULT)));

  private final BlobShadow shadows = new BlobShadow();

  @Test
  void itShrinksAndFadesWithHeight() {
    Shadow last = Shadow.on(0, 0);
    for (double above = 0.1; above < 10; above += 0.1) {
      Shadow higher = Shadow.on(0, above);
      assertThat(higher.radius()).isLessThan(last.radius());
      assertThat(higher.opacity()).isLessThan(last.opacity());
      last = higher;
    }
  }

  @Test
  void itCanBeSeenFromAnyHeight() {
    assertThat(Shadow.on(0, 200).opacity()).isGreaterThan(0.2);
    assertThat(Shadow.on(0, 200).radius()).isGreaterThan(0.07);
  }

  @Test
  void onTheFloorItIsALittleLargerThanTheDrone() {
    assertThat(Shadow.on(0, 0).radius()).isBetween(0.1, 0.2);
    assertThat(Shadow.on(0, -1)).isEqualTo(Shadow.on(0, 0));
  }

  @Test
  void besideAnObstacleItFallsOnTheFloor() {
    assertThat(shadows.cast(TABLE, new Vec3(0.6, 0, 1.2))).isEqualTo(Shadow.on(0, 1.2));
    assertThat(shadows.cast(Arena.DEFAULT, Vec3.ZERO)).isEqualTo(Shadow.on(0, 0));
  }

  @Test
  void overAnObstacleItFallsOnItsTop() {
    Instance shadow = shadows.of(TABLE, new Vec3(0.1, 0.1, 1.2));

    assertThat(shadow.pose().position().distanceTo(new Vec3(0.1, 0.1, 0.7)))
        .isCloseTo(0, within(1e-9));
    assertThat(shadow.scale().x()).isCloseTo(Shadow.on(0, 0.5).radius(), within(1e-9));
    assertThat(shadow.opacity()).isCloseTo(Shadow.on(0, 0.5).opacity(), within(1e-9));
  }

  @Test
  void aDroneThatStandsOnAnObstacleCastsItsShadowThere() {
    assertThat(shadows.cast(TABLE, new Vec3(0, 0, 0.7)).height()).isCloseTo(0.7, within(1e-9));
  }

  @Test
  void nearTheEdgeItDoesNotStandOut() {
    Shadow shadow = shadows.cast(TABLE, new Vec3(0.44, 0, 0.9));

    assertThat(shadow.height()).isCloseTo(0.7, within(1e-9));
    assertThat(shadow.radius()).isBetween(0.02, 0.06);
  }

  @Test
  void underAnObstacleItFallsOnTheFloor() {
    Arena shelf =
        TABLE.withObstacles(List.of(TABLE.obstacles().get(0).movedTo(new Vec3(0, 0, 1.5), 0)));

    assertThat(shadows.cast(shelf, new Vec3(0, 0, 1)).height()).isZero();
  }
}
