package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Part;
import tellosimulator.video.camera.Sketches.Sheet;

class PropsTest {

  private static final int GARBAGE_COLLECTIONS = 20;

  private final Props props = new Props(ColorSpace.YUV);

  @Test
  void whatIsSeenAgainIsNotMadeAgain() {
    Part part = part();

    assertThat(props.texture(part)).isSameAs(props.texture(part));
    assertThat(props.shape(part)).isSameAs(props.shape(part));
    assertThat(props.textures()).isEqualTo(1);
  }

  @Test
  void whatNobodyHasAnyMoreIsForgotten() {
    for (int i = 0; i < 50; i++) {
      props.texture(part());
    }

    for (int i = 0; i < GARBAGE_COLLECTIONS && props.textures() > 0; i++) {
      System.gc();
    }

    assertThat(props.textures()).isZero();
  }

  private static Part part() {
    return Sketches.painted(Sketches.noise(16, 1), Sheet.ahead(1, Vec3.ZERO, 1)).part();
  }
}
