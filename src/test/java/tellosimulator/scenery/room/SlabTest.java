package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;
import tellosimulator.world.Walls;

class SlabTest {

  private static final Room ROOM = new Room(6, 4, 3);

  @Test
  void nothingOfItIsInsideOrAboveTheFloor() {
    for (Part part : Slab.parts(ROOM)) {
      assertThat(positions(part.mesh()))
          .allMatch(place -> place.z() <= 0)
          .allMatch(place -> Math.abs(place.x()) >= 2 || Math.abs(place.y()) >= 3);
    }
  }

  @Test
  void itsShadowFadesToNothing() {
    Texture shadow = Slab.parts(ROOM).get(0).material().texture();

    for (int i = 0; i < shadow.width(); i++) {
      assertThat(shadow.argb(i, 0) >>> 24).isZero();
      assertThat(shadow.argb(0, i) >>> 24).isZero();
    }
    assertThat(shadow.argb(shadow.width() / 2, shadow.height() / 2) >>> 24).isGreaterThan(100);
  }

  @ParameterizedTest
  @EnumSource
  void itIsMadeOncePerRoomAndDronesDoNotSeeIt(Walls walls) {
    Interior interior = new Interior();
    Decor decor = Decor.DEFAULT.withWalls(walls);

    List<Instance> onSlab = interior.onSlab(ROOM, decor);
    List<Instance> inside = interior.instances(ROOM, decor);

    assertThat(onSlab).hasSize(inside.size() + 4).endsWith(inside.toArray(Instance[]::new));
    assertThat(interior.onSlab(ROOM, decor)).isSameAs(onSlab);
    assertThat(interior.onSlab(new Room(6, 4, 2), decor)).isNotEqualTo(onSlab);
  }

  private static Stream<Vec3> positions(Mesh mesh) {
    return Stream.iterate(0, i -> i + 1).limit(mesh.positions()).map(mesh::position);
  }
}
