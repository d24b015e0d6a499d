package tellosimulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.math.Vec3;

class ObstaclesTest {

  private static final Collider COLLIDER = new Collider(0.1, 0.04);
  private static final double STEP = 0.005;
  private static final double ROUNDING = 1e-9;

  /** The box is 0.4 m deep and 0.6 m wide, the collider's radius 0.1 m. */
  @ParameterizedTest
  @CsvSource({"1, 0, 0.3, 0", "-1, 0, -0.3, 0", "0, 1, 0, 0.4", "0, -1, 0, -0.4"})
  void aBoxStopsABodyFromEachSide(double fromX, double fromY, double endX, double endY) {
    Obstacles box = obstacles(new Shape.Box(0.4, 0.6, 1), Vec3.ZERO, 0);
    Vec3 from = new Vec3(fromX, fromY, 0.5);
    Vec3 velocity = new Vec3(-fromX, -fromY, 0);

    Collision hit =
        box.collide(from, new Vec3(0.05 * fromX, 0.05 * fromY, 0.5), velocity, COLLIDER)
            .orElseThrow();

    assertThat(hit.position().distanceTo(new Vec3(endX, endY, 0.5))).isLessThan(ROUNDING);
    assertThat(hit.normal()).isEqualTo(new Vec3(fromX, fromY, 0));
    assertThat(hit.speed()).isEqualTo(1);
    assertThat(hit.velocity()).isEqualTo(Vec3.ZERO);
    assertThat(hit.onGround()).isFalse();
    assertThat(hit.touched().phrase().english()).isEqualTo("the obstacle \"thing\"");
  }

  @Test
  void aTurnedBoxPushesAlongItsOwnSides() {
    Obstacles box = obstacles(new Shape.Box(1, 1, 1), Vec3.ZERO, Math.PI / 4);

    Collision hit =
        box.collide(new Vec3(0.8, 0.8, 0), new Vec3(0.3, 0.3, 0), new Vec3(-1, -1, 0), COLLIDER)
            .orElseThrow();

    double diagonal = Math.sqrt(0.5);
    assertThat(hit.normal().distanceTo(new Vec3(diagonal, diagonal, 0))).isLessThan(ROUNDING);
    assertThat(hit.position().norm())
        .as("half an edge and the radius")
        .isCloseTo(0.6, within(1e-9));
    assertThat(hit.speed()).isCloseTo(Math.sqrt(2), within(1e-9));
  }

  @Test
  void aBodySlidesAlongWhatItTouches() {
    Obstacles wall = obstacles(new Shape.Box(0.1, 4, 2), Vec3.ZERO, 0);

    Collision hit =
        wall.collide(new Vec3(-0.16, 0, 1), new Vec3(-0.12, 0.04, 1), new Vec3(8, 8, 0), COLLIDER)
            .orElseThrow();

    assertThat(hit.velocity()).isEqualTo(new Vec3(0, 8, 0));
    assertThat(hit.position().distanceTo(new Vec3(-0.15, 0.04, 1))).isLessThan(1e-9);
  }

  @Test
  void aBodyStandsOnABox() {
    Obstacles box = obstacles(new Shape.Box(1, 1, 0.5), Vec3.ZERO, 0);

    Collision hit =
        box.collide(new Vec3(0.2, 0, 0.501), new Vec3(0.2, 0, 0.49), new Vec3(0, 0, -2), COLLIDER)
            .orElseThrow();

    assertThat(hit.position().z()).isCloseTo(0.5, within(1e-12));
    assertThat(hit.onGround()).isTrue();
  }

  @Test
  void aBodyThatClimbsIsStoppedByWhatHangsOverIt() {
    Obstacles shelf = obstacles(new Shape.Box(1, 1, 0.1), new Vec3(0, 0, 1), 0);

    Collision hit =
        shelf
            .collide(new Vec3(0, 0, 0.95), new Vec3(0, 0, 0.97), new Vec3(0, 0, 1), COLLIDER)
            .orElseThrow();

    assertThat(hit.position().z()).as("below by its height").isCloseTo(0.96, within(1e-12));
    assertThat(hit.onGround()).isFalse();
  }

  @Test
  void anUprightCylinderPushesAwayFromItsAxis() {
    Obstacles pillar = obstacles(new Shape.Cylinder(0.2, 2), new Vec3(1, 1, 0), 0);

    Collision hit =
        pillar
            .collide(new Vec3(1, 0.5, 1), new Vec3(1, 0.75, 1), new Vec3(0, 1, 0), COLLIDER)
            .orElseThrow();

    assertThat(hit.position().distanceTo(new Vec3(1, 0.7, 1))).isLessThan(1e-9);
    assertThat(hit.normal()).isEqualTo(new Vec3(0, -1, 0));
  }

  /** A millimetre thick, at up to 100 m/s, in both directions and at any angle. */
  @ParameterizedTest
  @ValueSource(doubles = {0.5, 3, 20, 100})
  void nothingPassesAThinWall(double speed) {
    Obstacles wall = obstacles(new Shape.Box(0.001, 4, 3), Vec3.ZERO, 0);
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 300; i++) {
      double side = i % 2 == 0 ? 1 : -1;
      double angle = random.nextDouble(-1.2, 1.2);
      Vec3 velocity =
          new Vec3(
              -side * speed * Math.cos(angle), speed * Math.sin(angle), random.nextDouble(-1, 1));
      Vec3 position = new Vec3(side * random.nextDouble(0.11, 0.6), 0, 1.5);
      for (int step = 0; step < 60; step++) {
        Vec3 next = position.plusScaled(velocity, STEP);
        Optional<Collision> hit = wall.collide(position, next, velocity, COLLIDER);
        position = hit.map(Collision::position).orElse(next);
        velocity = hit.map(Collision::velocity).orElse(velocity);
        if (Math.abs(position.y()) < 1.9) {
          assertThat(side * position.x()).isGreaterThan(COLLIDER.radius());
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 10, 60})
  void nothingFallsThroughAThinPlate(double speed) {
    Obstacles plate = obstacles(new Shape.Box(2, 2, 0.001), new Vec3(0, 0, 1), 0.3);
    Vec3 position = new Vec3(0.3, -0.2, 1.2);
    Vec3 velocity = new Vec3(0, 0, -speed);
    for (int step = 0; step < 100; step++) {
      Vec3 next = position.plusScaled(velocity, STEP);
      Optional<Collision> hit = plate.collide(position, next, velocity, COLLIDER);
      position = hit.map(Collision::position).orElse(next);
      velocity = hit.map(Collision::velocity).orElse(velocity);
    }
    assertThat(position.z()).isCloseTo(1.001, within(1e-9));
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0, false",
    "0, 0.33, false",
    "0, 0.36, true",
    "0.28, 0, false",
    "0, 0.46, true",
    "0.35, 0, true",
    "-0.2, 0.2, false"
  })
  void oneFliesThroughTheOpeningOfARingOnly(double y, double up, boolean touches) {
    Obstacles ring = obstacles(new Shape.Ring(0.4, 0.06, 1.5), Vec3.ZERO, 0);

    assertThat(crosses(ring, y, 1.5 + up)).isEqualTo(touches);
  }

  @ParameterizedTest
  @CsvSource({"0, 0, false", "0.38, 0, false", "0.42, 0, true", "0, 0.34, false", "0, 0.38, true"})
  void oneFliesThroughTheOpeningOfAFrameOnly(double y, double up, boolean touches) {
    Obstacles frame = obstacles(new Shape.Frame(1, 0.8, 0.05, 1.2), Vec3.ZERO, 0);

    assertThat(crosses(frame, y, 1.2 + up)).isEqualTo(touches);
  }

  @Test
  void thePostOfARingIsInTheWayToo() {
    Obstacles ring = obstacles(new Shape.Ring(0.4, 0.06, 1.5), Vec3.ZERO, 0);

    assertThat(crosses(ring, 0, 0.5)).isTrue();
    assertThat(crosses(ring, 0.5, 0.5)).isFalse();
  }

  @Test
  void aRaySeesTheNearestSurface() {
    Obstacles box = obstacles(new Shape.Box(1, 1, 1), new Vec3(3, 0, 0), 0);
    Vec3 ahead = new Vec3(1, 0, 0);

    assertThat(box.distance(new Vec3(0, 0, 0.5), ahead, 10)).isCloseTo(2.5, within(1e-12));
    assertThat(box.distance(new Vec3(0, 0, 1.5), ahead, 10)).as("over it").isEqualTo(10);
    assertThat(box.distance(new Vec3(0, 0, 0.5), ahead, 2)).as("beyond the limit").isEqualTo(2);
    assertThat(box.distance(new Vec3(3, 0, 2), Vec3.UP.times(-1), 2)).isCloseTo(1, within(1e-12));
  }

  @Test
  void aRayPassesTheOpeningOfARing() {
    Obstacles ring = obstacles(new Shape.Ring(0.4, 0.1, 1.5), new Vec3(2, 0, 0), 0);
    Vec3 ahead = new Vec3(1, 0, 0);

    assertThat(ring.distance(new Vec3(0, 0, 1.5), ahead, 5)).isEqualTo(5);
    // the tube's middle is 0.45 m above the opening's, its radius 0.05 m
    assertThat(ring.distance(new Vec3(0, 0, 1.95), ahead, 5)).isCloseTo(1.95, within(0.001));
  }

  @Test
  void aRayHitsACylinderWhereItIsRound() {
    Obstacles pillar = obstacles(new Shape.Cylinder(0.5, 2), new Vec3(3, 0, 0), 0);

    // 0.3 m beside the axis the surface is 0.4 m in front of it: 0.5² = 0.3² + 0.4²
    assertThat(pillar.distance(new Vec3(0, 0.3, 1), new Vec3(1, 0, 0), 9))
        .isCloseTo(2.6, within(1e-12));
  }

  @Test
  void ofManyOnlyThoseNearbyAreLookedAtAndNoneIsMissed() {
    SplittableRandom random = new SplittableRandom(3);
    Room hall = new Room(40, 40, 5);
    List<Obstacle> many =
        random
            .doubles(400, -19, 19)
            .boxed()
            .limit(200)
            .map(
                x ->
                    thing(
                        new Shape.Cylinder(0.2, 2), new Vec3(x, random.nextDouble(-19, 19), 0), 0))
            .toList();
    Obstacles all = Obstacles.of(Arena.DEFAULT.withRoom(hall).withObstacles(many));
    for (Obstacle one : many) {
      assertThat(all.around(one.foot().plus(new Vec3(0.25, 0, 1)), COLLIDER)).isPresent();
    }
  }

  /** The index agrees with a test of each obstacle alone, which the plan uses. */
  @Test
  void aBodyIsInAnObstacleExactlyIfTheIndexFindsIt() {
    SplittableRandom random = new SplittableRandom(4);
    List<Shape> shapes =
        List.of(
            new Shape.Box(1, 0.5, 0.3),
            new Shape.Cylinder(0.4, 1),
            new Shape.Ring(0.5, 0.1, 0.7),
            new Shape.Frame(1, 1, 0.1, 0.6));
    for (Shape shape : shapes) {
      Obstacle one = thing(shape, new Vec3(0.2, -0.3, 0), 0.7);
      Obstacles index = obstacles(shape, one.foot(), one.heading());
      int found = 0;
      for (int i = 0; i < 1000; i++) {
        Vec3 place =
            new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(0, 1));
        boolean indexed = index.around(place, COLLIDER).isPresent();
        assertThat(one.intersects(place, COLLIDER)).as("%s at %s", shape, place).isEqualTo(indexed);
        found += indexed ? 1 : 0;
      }
      assertThat(found).isBetween(10, 990);
    }
  }

  /** A ring of 1 m opening, upright along y, whose tube is 10 cm thick, with a post. */
  private static final Shape RING = new Shape.Ring(0.5, 0.1, 1);

  private static List<Arguments> pairs() {
    Shape cube = new Shape.Box(1, 1, 1);
    Shape pole = new Shape.Cylinder(0.5, 2);
    return List.of(
        arguments(cube, new Vec3(1, 0, 0), 0.0, cube, false), // side by side
        arguments(cube, new Vec3(0.99, 0, 0), 0.0, cube, true),
        arguments(cube, new Vec3(1.2, 0, 0), Math.PI / 4, cube, true), // its corner reaches 0.707
        arguments(cube, new Vec3(1.21, 0, 0), Math.PI / 4, cube, false),
        arguments(cube, new Vec3(0, 0, 1), 0.3, cube, false), // on top
        arguments(cube, new Vec3(0.86, 0.86, 0), 0.0, pole, false), // 0.51 from the corner
        arguments(cube, new Vec3(0.84, 0.84, 0), 0.0, pole, true), // 0.48 from the corner
        arguments(pole, new Vec3(0.99, 0, 0), 0.0, pole, true),
        arguments(pole, new Vec3(1, 0, 0), 0.0, pole, false),
        arguments(new Shape.Box(0.4, 0.4, 0.4), new Vec3(0, 0, -0.8), 0.0, RING, false), // within
        arguments(new Shape.Box(0.4, 1.2, 0.4), new Vec3(0, 0, -0.8), 0.0, RING, true),
        arguments(new Shape.Box(0.2, 0.2, 0.3), Vec3.ZERO, 0.0, RING, true), // at its post
        arguments(new Shape.Box(0.2, 0.2, 0.3), new Vec3(0.3, 0, 0), 0.0, RING, false),
        arguments(RING, new Vec3(0, 0.3, 0), 0.0, RING, true),
        arguments(RING, new Vec3(0.2, 0, 0), 0.0, RING, false)); // one behind the other
  }

  @ParameterizedTest
  @MethodSource("pairs")
  void obstaclesOverlapIfTheyShareMoreThanASurface(
      Shape first, Vec3 offset, double heading, Shape second, boolean overlap) {
    Obstacle one = thing(first, new Vec3(0.3, -0.2, 1.5), 0);
    Obstacle other = thing(second, one.foot().plus(offset), heading);
    Obstacles both =
        Obstacles.of(
            Arena.empty(new Room(8, 8, 6), Decor.DEFAULT).withObstacles(List.of(one, other)));

    assertThat(both.overlapping(one, any -> true).isPresent()).isEqualTo(overlap);
    assertThat(both.overlapping(other, any -> true).isPresent()).isEqualTo(overlap);
    assertThat(both.overlapping(other, any -> false)).isEmpty();
  }

  @Test
  void aThousandThatFillAHugeRoomAreNoBurdenAndStillStop() {
    Room hall = new Room(200, 200, 10);
    List<Obstacle> plates =
        IntStream.range(0, 1000)
            .mapToObj(i -> thing(new Shape.Box(199, 199, 0.001), new Vec3(0, 0, 1 + 0.008 * i), 0))
            .toList();
    Runtime runtime = Runtime.getRuntime();
    runtime.gc();
    long before = runtime.totalMemory() - runtime.freeMemory();
    Obstacles all = Obstacles.of(Arena.DEFAULT.withRoom(hall).withObstacles(plates));
    long used = runtime.totalMemory() - runtime.freeMemory() - before;

    // in each of the 64 by 64 cells they would take 4096 · 1000 · 4 bytes twice, 33 MB
    assertThat(used).isLessThan(16_000_000);
    Collision hit =
        all.collide(new Vec3(50, 50, 0.95), new Vec3(50, 50, 0.97), Vec3.UP, COLLIDER)
            .orElseThrow();
    assertThat(hit.position().z()).as("below by its height").isCloseTo(0.96, within(1e-9));
  }

  private static boolean crosses(Obstacles obstacles, double y, double z) {
    Vec3 velocity = new Vec3(2, 0, 0);
    Vec3 position = new Vec3(-1, y, z);
    for (int step = 0; step < 200; step++) {
      Vec3 next = position.plusScaled(velocity, STEP);
      if (obstacles.collide(position, next, velocity, COLLIDER).isPresent()) {
        return true;
      }
      position = next;
    }
    return false;
  }

  private static Obstacles obstacles(Shape shape, Vec3 foot, double heading) {
    return Obstacles.of(
        Arena.DEFAULT
            .withRoom(new Room(10, 10, 5))
            .withObstacles(List.of(thing(shape, foot, heading))));
  }

  private static Obstacle thing(Shape shape, Vec3 foot, double heading) {
    return new Obstacle("thing", shape, foot, heading, ObstacleAppearance.DEFAULT);
  }
}
