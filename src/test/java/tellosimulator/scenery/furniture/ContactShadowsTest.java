package tellosimulator.scenery.furniture;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.RayTracer;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
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

class ContactShadowsTest {

  private static final Room ROOM = new Room(4, 6, 3);
  private static final Shape BOX = new Shape.Box(0.4, 0.6, 0.8);

  private final ContactShadows shadows = new ContactShadows();

  @Test
  void itIsDarkBesideABoxAndFadesOut() {
    RayTracer eye = eye(obstacle(BOX, new Vec3(1, 0, 0)));

    double beside = brightness(eye, 1.21, 0);
    double farther = brightness(eye, 1.35, 0);
    assertThat(beside).isLessThan(0.65 * 255);
    assertThat(farther).isBetween(beside + 20, 254.0);
    assertThat(brightness(eye, 1.75, 0)).isEqualTo(255);
    assertThat(brightness(eye, 1, 0.31)).as("on the other side").isLessThan(0.65 * 255);
  }

  @Test
  void itTurnsWithTheObstacle() {
    Obstacle turned = new Obstacle("box", BOX, Vec3.ZERO, Math.PI / 2, ObstacleAppearance.DEFAULT);

    RayTracer eye = eye(turned);

    assertThat(brightness(eye, 0.31, 0)).isLessThan(brightness(eye, 0, 0.31) - 30);
  }

  @Test
  void whatHangsCastsAWiderAndFainterOne() {
    Shape board = new Shape.Box(0.5, 0.5, 0.1);

    double low = brightness(eye(obstacle(board, new Vec3(0, 0, 0.3))), 0.01, 0.02);
    double high = brightness(eye(obstacle(board, new Vec3(0, 0, 0.8))), 0.01, 0.02);

    assertThat(high).isBetween(low + 20, 254.0);
  }

  @Test
  void theFloorUnderAGateIsDarkAtItsPosts() {
    RayTracer eye = eye(obstacle(new Shape.Frame(1, 0.8, 0.1, 1), Vec3.ZERO));

    assertThat(brightness(eye, 0.06, 0.55)).isLessThan(200);
    assertThat(brightness(eye, 0.06, 0)).isBetween(225.0, 254.9);
  }

  @Test
  void noneReachesOutOfTheRoom() {
    Obstacle corner =
        new Obstacle("box", BOX, new Vec3(2.9, 1.9, 0), 0.4, ObstacleAppearance.DEFAULT);

    for (Instance instance : shadows.instances(ROOM, List.of(corner))) {
      Mesh mesh = instance.part().mesh();
      for (int i = 0; i < mesh.positions(); i++) {
        assertThat(mesh.position(i).x()).isLessThanOrEqualTo(3 + 1e-6);
        assertThat(mesh.position(i).y()).isLessThanOrEqualTo(2 + 1e-6);
      }
    }
  }

  @Test
  void manyObstaclesHaveFewMeshes() {
    List<Obstacle> many =
        IntStream.range(0, 300)
            .mapToObj(i -> obstacle(BOX, new Vec3(0.01 * i - 1.5, 0, 0.01 * i)))
            .toList();

    assertThat(shadows.instances(ROOM, many).size()).isBetween(2, 12);
  }

  @Test
  void nothingIsMadeAgainForTheSameObstacles() {
    List<Obstacle> obstacles = List.of(obstacle(BOX, Vec3.ZERO));

    List<Instance> first = shadows.instances(ROOM, obstacles);

    assertThat(shadows.instances(ROOM, obstacles)).isSameAs(first);
    assertThat(shadows.instances(ROOM, List.of())).isEmpty();
  }

  private static Obstacle obstacle(Shape shape, Vec3 foot) {
    return new Obstacle("thing", shape, foot, 0, ObstacleAppearance.DEFAULT);
  }

  /** On a white floor. */
  private RayTracer eye(Obstacle obstacle) {
    int[] white = new int[1];
    Arrays.fill(white, Rgb.WHITE.argb());
    Part floor = new Part(MeshBuilder.of(Quad.onFloor(6)), new Texture(1, 1, white), Shading.UNLIT);
    List<Instance> instances = new ArrayList<>();
    instances.add(new Instance(floor, new Pose(Vec3.ZERO, Attitude.LEVEL)));
    instances.addAll(shadows.instances(ROOM, List.of(obstacle)));
    return new RayTracer(Scene.of(instances));
  }

  private static double brightness(RayTracer eye, double x, double y) {
    return 255 * eye.look(new Vec3(x, y, 2.9), new Vec3(0, 0, -1)).luma();
  }
}
