package tellosimulator.scenery.furniture;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.RayTracer;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Lights;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.MeshBuilder;
import tellosimulator.scenery.mesh.MeshBuilder.Quad;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;

class FloorShadowsTest {

  private static final Room ROOM = new Room(6, 6, 3);

  /** A ring of 0.4 m radius, its middle 1.2 m high. */
  private static final Shape RING = new Shape.Ring(0.4, 0.05, 1.2);

  private static final Shape BOX = new Shape.Box(0.4, 0.6, 0.8);

  private final FloorShadows shadows = new FloorShadows();

  @Test
  void theShadowOfABoardIsWhereTheKeyLightLeads() {
    Vec3 place = new Vec3(-1, 1, 0);
    RayTracer eye = eye(new Shape.Box(0.4, 0.4, 0.05), place.withZ(2));
    Vec3 shadow = onFloor(place.withZ(2));

    assertThat(brightness(eye, shadow)).isBetween(160.0, 190.0);
    assertThat(brightness(eye, shadow.plus(new Vec3(0.5, 0, 0)))).isEqualTo(255);
    assertThat(brightness(eye, shadow.plus(new Vec3(0, -0.5, 0)))).isEqualTo(255);
  }

  @Test
  void itIsDarkBesideABoxAndFadesOut() {
    RayTracer eye = eye(BOX, new Vec3(1, 0, 0));

    // on the side of the key light, which leads to the front and to the right
    double beside = brightness(eye, new Vec3(0.79, 0, 0));
    double farther = brightness(eye, new Vec3(0.65, 0, 0));
    assertThat(beside).isLessThan(0.65 * 255);
    assertThat(farther).isBetween(beside + 20, 254.0);
    assertThat(brightness(eye, new Vec3(0.2, 0, 0))).isEqualTo(255);
    assertThat(brightness(eye, new Vec3(1, 0.31, 0))).as("on the left").isLessThan(0.65 * 255);
  }

  @Test
  void itTurnsWithTheObstacle() {
    RayTracer eye = eye(6, shadows.instances(ROOM, obstacles(BOX, Vec3.ZERO, Math.PI / 2)));

    assertThat(brightness(eye, new Vec3(-0.31, 0, 0)))
        .isLessThan(brightness(eye, new Vec3(0, 0.31, 0)) - 30);
  }

  @Test
  void straightBelowItIsFainterTheHigherAnObstacleHangs() {
    Shape board = new Shape.Box(0.3, 0.3, 0.1);

    double low = brightness(eye(board, Vec3.UP.times(0.25)), Vec3.ZERO);
    double high = brightness(eye(board, Vec3.UP.times(0.8)), Vec3.ZERO);

    assertThat(high).isBetween(low + 20, 254.0);
  }

  @Test
  void lightFallsThroughARing() {
    RayTracer eye = eye(RING, Vec3.ZERO);

    double through = brightness(eye, onFloor(new Vec3(0, 0, 1.2)));
    double side = brightness(eye, onFloor(new Vec3(0, 0.4, 1.2)));
    double post = brightness(eye, onFloor(new Vec3(0, 0, 0.4)));
    assertThat(through).isGreaterThan(250);
    assertThat(side).isLessThan(230);
    assertThat(post).isLessThan(220);
  }

  @Test
  void theHigherAnEdgeTheSofterItsShadow() {
    assertThat(steepest(eye(new Shape.Box(1, 1, 0.02), Vec3.ZERO), 0))
        .isGreaterThan(2 * steepest(eye(new Shape.Box(1, 1, 0.02), Vec3.UP.times(2)), 2));
  }

  /**
   * Returns the largest change of brightness within 2 cm across the front edge of a board at a
   * height.
   */
  private static double steepest(RayTracer eye, double height) {
    double steepest = 0;
    for (double x = 0.2; x < 0.8; x += 0.005) {
      double before = brightness(eye, onFloor(new Vec3(x, 0, height)));
      double after = brightness(eye, onFloor(new Vec3(x + 0.02, 0, height)));
      steepest = Math.max(steepest, after - before);
    }
    return steepest;
  }

  @Test
  void inALargeRoomThePostOfAGateCastsOne() {
    Room hall = new Room(20, 20, 3);
    List<Obstacle> obstacles =
        List.of(
            new Obstacle("a", RING, new Vec3(8, 8, 0), 0, ObstacleAppearance.DEFAULT),
            new Obstacle("b", RING, new Vec3(-8, -8, 0), 0, ObstacleAppearance.DEFAULT));
    RayTracer eye = eye(20, shadows.instances(hall, new Furniture().instances(obstacles)));

    for (double height = 0.2; height < 0.7; height += 0.05) {
      assertThat(brightness(eye, Lights.onFloor(new Vec3(8, 8, height)))).isLessThan(245);
    }
  }

  @Test
  void thousandsOfGatesCastNone() {
    List<Obstacle> gates =
        IntStream.range(0, 3000)
            .mapToObj(i -> new Obstacle("", RING, Vec3.ZERO, i, ObstacleAppearance.DEFAULT))
            .toList();

    assertThat(shadows.instances(ROOM, new Furniture().instances(gates))).isEmpty();
  }

  @Test
  void noneReachesOutOfTheRoom() {
    Mesh mesh = made(new Shape.Box(0.4, 0.4, 2), new Vec3(2.7, -2.7, 0)).get(0).part().mesh();

    for (int i = 0; i < mesh.positions(); i++) {
      assertThat(Math.abs(mesh.position(i).x())).isLessThanOrEqualTo(3 + 1e-6);
      assertThat(Math.abs(mesh.position(i).y())).isLessThanOrEqualTo(3 + 1e-6);
    }
  }

  @Test
  void whatIsTranslucentCastsNone() {
    Part pane =
        new Part(
            MeshBuilder.of(Quad.onFloor(1)),
            new Texture(1, 1, new int[] {Rgb.BLACK.argb(0.5)}),
            Shading.TRANSLUCENT);
    Instance raised = new Instance(pane, new Pose(Vec3.UP, Attitude.LEVEL));

    assertThat(shadows.instances(ROOM, List.of(raised))).isEmpty();
  }

  @Test
  void nothingIsMadeAgainForTheSameObstaclesInTheSameRoom() {
    List<Instance> obstacles = obstacles(RING, Vec3.ZERO);

    List<Instance> first = shadows.instances(ROOM, obstacles);

    assertThat(first).isNotEmpty();
    assertThat(shadows.instances(ROOM, obstacles)).isSameAs(first);
    assertThat(shadows.instances(new Room(4, 4, 3), obstacles)).isNotSameAs(first);
    assertThat(shadows.instances(ROOM, List.of())).isEmpty();
  }

  private List<Instance> made(Shape shape, Vec3 foot) {
    return shadows.instances(ROOM, obstacles(shape, foot));
  }

  private static List<Instance> obstacles(Shape shape, Vec3 foot) {
    return obstacles(shape, foot, 0);
  }

  private static List<Instance> obstacles(Shape shape, Vec3 foot, double heading) {
    return new Furniture()
        .instances(
            List.of(new Obstacle("thing", shape, foot, heading, ObstacleAppearance.DEFAULT)));
  }

  /** Projects a point along the key light onto the floor. */
  private static Vec3 onFloor(Vec3 point) {
    Vec3 light = Lights.KEY.times(1 / -Lights.KEY.z());
    return new Vec3(point.x() + light.x() * point.z(), point.y() + light.y() * point.z(), 0);
  }

  /** Returns a ray tracer for a white floor with the shadow, but without the obstacle itself. */
  private RayTracer eye(Shape shape, Vec3 foot) {
    return eye(6, made(shape, foot));
  }

  private static RayTracer eye(double size, List<Instance> shadows) {
    Texture white = new Texture(1, 1, new int[] {Rgb.WHITE.argb()});
    Part floor = new Part(MeshBuilder.of(Quad.onFloor(size)), white, Shading.UNLIT);
    List<Instance> instances = new ArrayList<>(List.of(Instance.atOrigin(floor)));
    instances.addAll(shadows);
    return new RayTracer(Scene.of(instances));
  }

  private static double brightness(RayTracer eye, Vec3 place) {
    return 255 * eye.look(place.withZ(2.9), new Vec3(0, 0, -1)).luma();
  }
}
