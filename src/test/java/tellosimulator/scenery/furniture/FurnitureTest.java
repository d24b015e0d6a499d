package tellosimulator.scenery.furniture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.ObstacleAppearance.Side;
import tellosimulator.world.Shape;

class FurnitureTest {

  private static final Shape BOX = new Shape.Box(0.4, 0.6, 0.8);

  private final Furniture furniture = new Furniture();

  @Test
  void theMeshOfABoxEnclosesIt() {
    assertThat(volume(BOX)).isCloseTo(0.4 * 0.6 * 0.8, within(1e-6));
  }

  /** A circle of 28 sides has 0.8 % less area than a round one, that of 14 sides 3.3 % less. */
  @Test
  void theMeshOfACylinderEnclosesIt() {
    double round = Math.PI * 0.25 * 0.25 * 0.9;
    assertThat(volume(new Shape.Cylinder(0.25, 0.9))).isBetween(0.98 * round, round);
  }

  @Test
  void theMeshOfAGateEnclosesIt() {
    // beams: two of 0.8 + 2 * 0.1 m and two of 0.6 m, posts: two of 0.5 m
    double frame = 0.1 * 0.1 * (2 * 1 + 2 * 0.6 + 2 * 0.5);
    assertThat(volume(new Shape.Frame(0.6, 0.8, 0.1, 1))).isCloseTo(frame, within(1e-6));

    // a torus is as long as its middle, 0.5 + 0.05 m from the centre; its tube has few sides,
    // and the post stands 0.45 m high and 0.05 m into the ring, without an upper end
    double ring = 2 * Math.PI * 0.55 * Math.PI * 0.05 * 0.05;
    double post = Math.PI * 0.05 * 0.05 * 0.45;
    assertThat(volume(new Shape.Ring(0.5, 0.1, 1.05))).isCloseTo(ring + post, within(0.15 * ring));
  }

  @Test
  void aGateThatStandsOnTheFloorHasNoPosts() {
    assertThat(parts(new Shape.Ring(0.5, 0.1, 0.6), ObstacleAppearance.DEFAULT)).hasSize(1);
    assertThat(parts(new Shape.Frame(0.6, 0.8, 0.1, 0.4), ObstacleAppearance.DEFAULT)).hasSize(1);
  }

  @Test
  void theOpeningOfARingIsFree() {
    Mesh ring = parts(new Shape.Ring(0.5, 0.1, 2), ObstacleAppearance.DEFAULT).get(1).mesh();

    for (int i = 0; i < ring.positions(); i++) {
      Vec3 out = ring.position(i).minus(new Vec3(0, 0, 2));
      assertThat(Math.hypot(out.y(), out.z())).isBetween(0.5 - 1e-6, 0.6 + 1e-6);
      assertThat(out.x()).isBetween(-0.05 - 1e-6, 0.05 + 1e-6);
    }
  }

  @ParameterizedTest
  @EnumSource
  void aPatternIsNearTheColorAndHasDetailButForPlainPaint(Pattern pattern) {
    Texture texture = parts(BOX, paint(pattern)).get(0).material().texture();

    int own = 0;
    double sum = 0;
    double squares = 0;
    int[] pixels = texture.argbArray();
    for (int pixel : pixels) {
      Rgb rgb = Rgb.of(pixel);
      own += rgb.blue() > rgb.red() + 40 ? 1 : 0;
      sum += rgb.green();
      squares += rgb.green() * rgb.green();
    }
    double mean = sum / pixels.length;
    double deviation = Math.sqrt(squares / pixels.length - mean * mean);
    assertThat(own).as("bluish pixels").isGreaterThan(pixels.length * 2 / 5);
    if (pattern == Pattern.PLAIN) {
      assertThat(deviation).isBetween(0.3, 10.0);
    } else {
      assertThat(deviation).isGreaterThan(15);
    }
  }

  @Test
  void sidesWithPicturesAreAsBrightAsTheirFilesAndTheOthersArePainted() {
    ObstacleAppearance appearance =
        new ObstacleAppearance(
            0x0000ff,
            Pattern.PLAIN,
            Map.of(Side.FRONT, "examples/marker.png", Side.TOP, "no/such.png"));

    List<Part> parts = parts(BOX, appearance);

    assertThat(parts)
        .extracting(part -> part.material().shading())
        .containsExactly(Shading.MATTE, Shading.UNLIT, Shading.UNLIT);
    assertThat(parts.get(0).mesh().triangles()).isEqualTo(2 * 4);
    Mesh front = parts.get(1).mesh();
    for (int i = 0; i < front.positions(); i++) {
      assertThat(front.position(i).x()).isCloseTo(0.2, within(1e-6));
    }
    Texture blank = parts.get(2).material().texture();
    assertThat(Rgb.of(blank.argb(0, 0))).isEqualTo(Rgb.of(0x9a9a9a));
  }

  @Test
  void aPictureGoesAroundACylinderAndIsUprightFromTheFront() {
    ObstacleAppearance appearance =
        new ObstacleAppearance(0, Pattern.PLAIN, Map.of(Side.FRONT, "examples/marker.png"));
    Mesh around = parts(new Shape.Cylinder(0.3, 1), appearance).get(1).mesh();
    float[] texCoords = around.texCoordArray();

    for (int i = 0; i < around.positions(); i++) {
      Vec3 point = around.position(i);
      double turn = Math.atan2(point.y(), point.x()) / (2 * Math.PI);
      double v = texCoords[2 * i + 1];
      assertThat(v).isCloseTo(point.z() > 0.5 ? 0 : 1, within(0.005));
      if (Math.abs(turn) < 0.49) {
        assertThat((double) texCoords[2 * i]).isCloseTo(0.5 + turn, within(0.005));
      }
    }
  }

  @Test
  void likeThingsShareTheirParts() {
    Obstacle one = new Obstacle("one", BOX, new Vec3(1, 0, 0), 0, paint(Pattern.BRICKS));
    Obstacle other = new Obstacle("other", BOX, new Vec3(2, 0, 0), 1, paint(Pattern.BRICKS));
    Obstacle third =
        new Obstacle("third", new Shape.Cylinder(1, 1), Vec3.ZERO, 1, paint(Pattern.BRICKS));

    List<Instance> instances = furniture.instances(List.of(one, other, third));

    assertThat(instances.get(0).part()).isSameAs(instances.get(1).part());
    assertThat(instances.get(0).pose()).isEqualTo(one.pose());
    assertThat(instances.get(1).pose()).isEqualTo(other.pose());
    assertThat(instances.get(2).part().material().texture())
        .isSameAs(instances.get(0).part().material().texture());
  }

  @Test
  void nothingIsMadeAgainForTheSameOrAMovedObstacle() {
    Obstacle here = new Obstacle("one", BOX, new Vec3(1, 0, 0), 0, ObstacleAppearance.DEFAULT);
    List<Obstacle> obstacles = List.of(here);

    List<Instance> first = furniture.instances(obstacles);

    assertThat(furniture.instances(obstacles)).isSameAs(first);
    List<Instance> moved = furniture.instances(List.of(here.movedTo(new Vec3(2, 0, 0), 0.5)));
    assertThat(moved.get(0).part()).isSameAs(first.get(0).part());
    assertThat(furniture.instances(List.of())).isEmpty();
  }

  @Test
  void manyPatternsHaveSmallPicturesAsNobodyKeepsAThousandLargeOnes() {
    List<Obstacle> many =
        IntStream.range(0, 1000)
            .mapToObj(i -> new ObstacleAppearance(17 * i, Pattern.BRICKS, Map.of()))
            .map(appearance -> new Obstacle("thing", BOX, Vec3.ZERO, 0, appearance))
            .toList();

    assertThat(furniture.instances(many.subList(0, 16)).get(0).part().material().texture().width())
        .isEqualTo(512);
    assertThat(furniture.instances(many.subList(0, 17)).get(0).part().material().texture().width())
        .isEqualTo(256);
    // 1000 times 64 times 64 pixels of 4 bytes: 16 MB
    assertThat(furniture.instances(many).get(0).part().material().texture().width()).isEqualTo(64);
  }

  private static ObstacleAppearance paint(Pattern pattern) {
    return new ObstacleAppearance(0x2040e0, pattern, Map.of());
  }

  private List<Part> parts(Shape shape, ObstacleAppearance appearance) {
    return furniture
        .instances(List.of(new Obstacle("thing", shape, Vec3.ZERO, 0, appearance)))
        .stream()
        .map(Instance::part)
        .filter(part -> part.material().shading() != Shading.TRANSLUCENT)
        .toList();
  }

  @Test
  void whatStandsHasShadeAtItsFeetUnlessItShowsAPicture() {
    ObstacleAppearance marked =
        new ObstacleAppearance(0, Pattern.PLAIN, Map.of(Side.FRONT, "examples/marker.png"));
    Obstacle standing = new Obstacle("one", BOX, Vec3.ZERO, 0, ObstacleAppearance.DEFAULT);
    Obstacle hanging = standing.movedTo(new Vec3(0, 0, 1), 0);

    assertThat(shade(standing)).isTrue();
    assertThat(shade(hanging)).isFalse();
    assertThat(shade(new Obstacle("two", BOX, Vec3.ZERO, 0, marked))).isFalse();
  }

  private boolean shade(Obstacle obstacle) {
    return furniture.instances(List.of(obstacle)).stream()
        .anyMatch(instance -> instance.part().material().shading() == Shading.TRANSLUCENT);
  }

  /**
   * Returns the volume within all meshes of a shape [m³], less that of meshes that face inwards.
   */
  private double volume(Shape shape) {
    double volume = 0;
    for (Part part : parts(shape, ObstacleAppearance.DEFAULT)) {
      Mesh mesh = part.mesh();
      int[] corners = mesh.faceArray();
      for (int i = 0; i < corners.length; i += 9) {
        Vec3 b = mesh.position(corners[i + 3]);
        Vec3 c = mesh.position(corners[i + 6]);
        volume += mesh.position(corners[i]).dot(b.cross(c)) / 6;
      }
    }
    return volume;
  }
}
