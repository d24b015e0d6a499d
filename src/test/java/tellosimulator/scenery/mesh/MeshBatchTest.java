package tellosimulator.scenery.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.furniture.Furniture;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.ObstacleAppearance.Pattern;
import tellosimulator.world.Shape;

class MeshBatchTest {

  private static final Shape BOX = new Shape.Box(0.2, 0.2, 0.5);

  @Test
  void whatHasTheSameMaterialBecomesOnePart() {
    ObstacleAppearance red = new ObstacleAppearance(0xff0000, Pattern.PLAIN, Map.of());
    ObstacleAppearance green = new ObstacleAppearance(0x00ff00, Pattern.PLAIN, Map.of());

    List<Part> joined =
        MeshBatch.of(
            new Furniture()
                .instances(
                    List.of(
                        new Obstacle("a", BOX, new Vec3(1, 0, 0), 0, red),
                        new Obstacle("b", BOX, new Vec3(2, 0, 0), 0, green),
                        new Obstacle("c", BOX, new Vec3(3, 0, 0), 0, red))));

    // two red boxes, a green one, and the shade at the feet of all three: eight triangles each
    assertThat(joined).extracting(part -> part.mesh().triangles()).containsExactly(24, 12, 24);
  }

  @Test
  void everythingStaysWhereItIs() {
    Obstacle turned =
        new Obstacle("a", BOX, new Vec3(1, 2, 0.3), Math.toRadians(90), ObstacleAppearance.DEFAULT);
    Obstacle other = new Obstacle("b", BOX, new Vec3(-1, 0, 0), 0.4, ObstacleAppearance.DEFAULT);
    List<Instance> apart = new Furniture().instances(List.of(other, turned));

    Mesh own = apart.get(1).part().mesh();
    Mesh joined = MeshBatch.of(apart).get(0).mesh();

    int[] corners = own.faceArray();
    int[] found = joined.faceArray();
    for (int i = 0; i < corners.length; i++) {
      int there = found[corners.length + i];
      if (i % 3 == 0) {
        Vec3 point = own.position(corners[i]);
        Vec3 inRoom = new Vec3(1 - point.y(), 2 + point.x(), 0.3 + point.z());
        assertThat(joined.position(there).distanceTo(inRoom)).isCloseTo(0, within(1e-6));
      } else if (i % 3 == 1) {
        assertThat(joined.normalArray()[3 * there])
            .isCloseTo(-own.normalArray()[3 * corners[i] + 1], within(1e-6f));
      } else {
        assertThat(joined.texCoordArray()[2 * there])
            .isEqualTo(own.texCoordArray()[2 * corners[i]]);
      }
    }
  }
}
