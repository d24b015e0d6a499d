package tellosimulator.scenery.room;

import java.util.Arrays;
import java.util.OptionalInt;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/**
 * The bricks of the front wall, tinted with a room's accent colour. Each texel keeps its brightness
 * as far as the new hue allows, so programs find the same number of features. Mortar keeps its
 * colour.
 */
final class AccentBricks {

  private AccentBricks() {}

  /** Returns the tinted bricks, or the default bricks if there is no accent. */
  static Texture of(OptionalInt accent) {
    Texture bricks = SurfaceTexture.BRICKS.texture();
    if (accent.isEmpty()) {
      return bricks;
    }
    Rgb wanted = Rgb.of(accent.getAsInt());
    return Texture.lazy(
        bricks.width(),
        bricks.height(),
        () -> Arrays.stream(bricks.argbArray()).map(texel -> tinted(texel, wanted)).toArray());
  }

  /**
   * Replaces the default hue with the wanted hue, in proportion to how much of the default hue the
   * texel has.
   */
  private static int tinted(int texel, Rgb wanted) {
    Rgb usual = CalmTextures.ACCENT;
    Rgb was = Rgb.of(texel);
    double part = (double) (was.green() - was.red()) / (usual.green() - usual.red());
    double lighter = 255 * (usual.luma() - wanted.luma());
    return new Rgb(
            channel(was.red() + part * (wanted.red() - usual.red() + lighter)),
            channel(was.green() + part * (wanted.green() - usual.green() + lighter)),
            channel(was.blue() + part * (wanted.blue() - usual.blue() + lighter)))
        .argb();
  }

  private static int channel(double value) {
    return (int) Math.max(0, Math.min(255, Math.round(value)));
  }
}
