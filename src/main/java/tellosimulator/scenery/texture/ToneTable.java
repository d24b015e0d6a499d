package tellosimulator.scenery.texture;

import java.util.SplittableRandom;

/**
 * A random tone for each of many like things: bricks, boards, tiles. From 0 to 1, evenly spread but
 * seldom in the middle, so that neighbours mostly differ. Equal seeds give equal tones. Immutable;
 * for any thread.
 */
public final class ToneTable {

  /** How far from the middle they are pushed: 1 not at all, 0 all the way. Decided: by eye. */
  private static final double SPREAD = 0.55;

  private final double[] tones;

  /**
   * @param count of things
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

  /** The tone of a thing. */
  public double tone(int index) {
    return tones[index];
  }
}
