package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ColorSpaceTest {

  /** ITU-R BT.601 in 8 bits: Y 16 + 65.481 R + 128.553 G + 24.966 B, and so on, R from 0 to 1. */
  @ParameterizedTest
  @CsvSource(
      textBlock =
          """
          ff000000,  16, 128, 128
          ffffffff, 235, 128, 128
          ff808080, 126, 128, 128
          ffff0000,  81,  90, 240
          ff00ff00, 145,  54,  34
          ff0000ff,  41, 240, 110
          """)
  void yCbCrIsThatOfBt601(String argb, int y, int u, int v) {
    int packed = ColorSpace.YUV.pack(Integer.parseUnsignedInt(argb, 16));

    assertThat((packed >> 16) & 255).as("Y").isCloseTo(y, within(0));
    assertThat((packed >> 8) & 255).as("Cb").isCloseTo(u, within(0));
    assertThat(packed & 255).as("Cr").isCloseTo(v, within(0));
    assertThat(packed >>> 24).as("alpha").isEqualTo(255);
  }

  @ParameterizedTest
  @CsvSource({"0", "1", "128", "255"})
  void alphaIsKept(int alpha) {
    assertThat(ColorSpace.YUV.pack(alpha << 24 | 0x123456) >>> 24).isEqualTo(alpha);
    assertThat(ColorSpace.RGB.pack(alpha << 24 | 0x123456)).isEqualTo(alpha << 24 | 0x123456);
  }
}
