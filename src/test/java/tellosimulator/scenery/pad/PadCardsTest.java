package tellosimulator.scenery.pad;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Finish;
import tellosimulator.scenery.Placed;
import tellosimulator.scenery.Rgb;
import tellosimulator.scenery.Texture;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Room;

class PadCardsTest {

  private final PadCards cards = new PadCards();

  @Test
  void aCardIsADecalAtThePlaceOfThePad() {
    MissionPad pad = MissionPad.onFloor(3, new Vec3(1, -0.5, 0), 0.7);

    Placed placed = cards.placed(Room.DEFAULT, List.of(pad)).get(0);

    assertThat(placed.part().finish()).isEqualTo(Finish.DECAL);
    assertThat(placed.pose()).isEqualTo(pad.pose(Room.DEFAULT));
  }

  @Test
  void aCardIsPrintedOnce() {
    MissionPad here = MissionPad.onFloor(3, new Vec3(1, -0.5, 0), 0.7);
    MissionPad there = MissionPad.onFloor(3, Vec3.ZERO, 0);

    assertThat(cards.placed(Room.DEFAULT, List.of(here)).get(0).part())
        .isSameAs(cards.placed(Room.DEFAULT, List.of(there)).get(0).part());
  }

  @Test
  void itsEdgeIsWhiteWithinThatThereIsABlackBorder() {
    Texture picture = PadDesign.texture(5);

    assertThat(Rgb.of(picture.argb(4, 256)).red()).isGreaterThan(240);
    assertThat(Rgb.of(picture.argb(22, 256)).red()).isLessThan(40);
    assertThat(picture.argb(256, 256) >>> 24).as("opaque").isEqualTo(255);
  }
}
