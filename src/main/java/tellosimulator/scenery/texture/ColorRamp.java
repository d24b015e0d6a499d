package tellosimulator.scenery.texture;

import tellosimulator.scenery.mesh.Rgb;

/** A gradient of opaque colours from dark to light. Immutable. */
public final class ColorRamp {

  private static final int STEPS = 256;

  private final int[] pixels = new int[STEPS];

  public ColorRamp(Rgb dark, Rgb light) {
    for (int i = 0; i < STEPS; i++) {
      pixels[i] = dark.towards(light, i / (STEPS - 1.0)).argb();
    }
  }

  /**
   * Returns the colour of a tone, as an opaque ARGB value.
   *
   * @param tone 0 for the dark end, 1 for the light end; values outside this range are clamped
   */
  public int argb(double tone) {
    return pixels[(int) Math.max(0, Math.min(STEPS - 1, tone * STEPS))];
  }
}
