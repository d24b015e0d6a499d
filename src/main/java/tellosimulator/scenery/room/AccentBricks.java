package tellosimulator.scenery.room;

import java.util.Arrays;
import java.util.OptionalInt;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Texture;

/**
 * The bricks of the front wall in the hue of a room's accent. Each texel is as bright as in the
 * file, as far as the hue has such a color, so that programs find as many features; mortar keeps
 * its color.
 */
final class AccentBricks {

  private AccentBricks() {}

  /** The usual ones if there is no accent. */
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

  /** Takes away the usual hue, as far as a texel has it, and adds as much of the wanted one. */
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
