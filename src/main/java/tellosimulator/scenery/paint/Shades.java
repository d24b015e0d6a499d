package tellosimulator.scenery.paint;

import tellosimulator.scenery.Rgb;

/** All shades from a dark colour to a light one. Immutable; for any thread. */
public final class Shades {

  private static final int STEPS = 256;

  private final int[] pixels = new int[STEPS];

  public Shades(Rgb dark, Rgb light) {
    for (int i = 0; i < STEPS; i++) {
      pixels[i] = dark.towards(light, i / (STEPS - 1.0)).argb();
    }
  }

  /**
   * A pixel.
   *
   * @param tone 0 is dark, 1 light; beyond that they stay
   */
  public int argb(double tone) {
    return pixels[(int) Math.max(0, Math.min(STEPS - 1, tone * STEPS))];
  }
}
