package tellosimulator.scenery.room;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SurfaceTextureTest {

  /** These files contain all filter types of PNG. */
  @ParameterizedTest
  @EnumSource
  void itIsTheImageFile(SurfaceTexture surface) throws IOException {
    String file = surface.name().toLowerCase(Locale.ROOT) + ".png";
    BufferedImage image = ImageIO.read(SurfaceTexture.class.getResource(file));
    int width = image.getWidth();

    assertThat(surface.texture().argbArray())
        .isEqualTo(image.getRGB(0, 0, width, image.getHeight(), null, 0, width));
  }
}
