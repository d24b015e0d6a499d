package tellosimulator.scenery.texture;

import java.util.SplittableRandom;

/**
 * A random tone for each of many similar objects, such as bricks, boards or tiles. Tones are
 * between 0 and 1. Dark and light tones are equally frequent and medium tones are rare, so
 * neighbours mostly differ. Equal seeds give equal tones. Immutable.
 */
public final class ToneTable {

  /**
   * Exponent that pushes tones away from the middle: 1 leaves them unchanged, and 0 pushes them to
   * 0 and 1. Decided: by eye.
   */
  private static final double SPREAD = 0.55;

  private final double[] tones;

  /**
   * Creates the tones.
   *
   * @param count number of tones
   */
  public ToneTable(int count, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    tones = new double[count];
    for (int i = 0; i < count; i++) {
      int other = random.nextInt(i + 1);
      tones[i] = tones[other];
      double signed = 2 * (i + 0.5) / count - 1;
      tones[other] = 0.5 + Math.signum(signed) * StrictMath.pow(Math.abs(signed), SPREAD) / 2;
    }
  }

  /** Returns the tone of an object. */
  public double tone(int index) {
    return tones[index];
  }
}
