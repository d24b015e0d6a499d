package tellosimulator.scenery.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class TextureTest {

  private static final int OPAQUE = 0xff000000;

  @Test
  void aChangedArrayChangesNoTexture() {
    int[] argb = {OPAQUE};
    Texture texture = new Texture(1, 1, argb);

    argb[0] = 0;
    texture.argbArray()[0] = 0;

    assertThat(texture.argb(0, 0)).isEqualTo(OPAQUE);
  }

  @Test
  void aFadedOneHasTheSameColorsAndAPartOfTheirOpacity() {
    Texture texture = new Texture(2, 1, new int[] {OPAQUE | 0x123456, 0x80abcdef});

    // half of 255, rounded up, and of 128
    assertThat(texture.faded(0.5).argbArray()).containsExactly(0x80123456, 0x40abcdef);
  }

  @Test
  void texelsMustBeAsManyAsTheSizeSays() {
    assertThatThrownBy(() -> new Texture(2, 1, new int[1]))
        .hasMessage("argb has 1 texels, but must have 2 times 1");
    assertThatThrownBy(() -> Texture.lazy(2, 1, () -> new int[1]).argb(0, 0))
        .hasMessage("argb has 1 texels, but must have 2 times 1");
  }
}
