package tellosimulator.scenery.texture;

import tellosimulator.scenery.mesh.Rgb;

/** A gradient of opaque colours from a dark one to a light one. Immutable; for any thread. */
public final class ColorRamp {

  private static final int STEPS = 256;

  private final int[] pixels = new int[STEPS];

  public ColorRamp(Rgb dark, Rgb light) {
    for (int i = 0; i < STEPS; i++) {
      pixels[i] = dark.towards(light, i / (STEPS - 1.0)).argb();
    }
  }

  /**
   * A texel.
   *
   * @param tone 0 is dark, 1 light; clamped to that
   */
  public int argb(double tone) {
    return pixels[(int) Math.max(0, Math.min(STEPS - 1, tone * STEPS))];
  }
}
