package tellosimulator.scenery.pad;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;

class PadDecalsTest {

  private final PadDecals pads = new PadDecals();

  @Test
  void aCardIsADecalAtThePlaceOfThePad() {
    MissionPad pad = MissionPad.onFloor(3, new Vec3(1, -0.5, 0), 0.7);

    Instance placed = pads.instances(Room.DEFAULT, List.of(pad)).get(0);

    assertThat(placed.part().material().shading()).isEqualTo(Shading.DECAL);
    assertThat(placed.pose()).isEqualTo(pad.pose(Room.DEFAULT));
  }

  @Test
  void aDecalIsMadeOnce() {
    MissionPad here = MissionPad.onFloor(3, new Vec3(1, -0.5, 0), 0.7);
    MissionPad there = MissionPad.onFloor(3, Vec3.ZERO, 0);

    assertThat(pads.instances(Room.DEFAULT, List.of(here)).get(0).part())
        .isSameAs(pads.instances(Room.DEFAULT, List.of(there)).get(0).part());
  }

  @Test
  void itsEdgeIsWhiteWithinThatThereIsABlackBorder() {
    Texture texture = PadTexture.of(5);

    assertThat(Rgb.of(texture.argb(4, 256)).red()).isGreaterThan(240);
    assertThat(Rgb.of(texture.argb(22, 256)).red()).isLessThan(40);
    assertThat(texture.argb(256, 256) >>> 24).as("opaque").isEqualTo(255);
  }
}
