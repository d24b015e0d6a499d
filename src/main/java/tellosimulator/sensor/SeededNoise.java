package tellosimulator.sensor;

import java.util.Random;

/**
 * Random numbers that depend only on the seed, the drone, what they are for and when: who reads a
 * sensor, and how often, changes nothing. Immutable; for any thread.
 */
public final class SeededNoise {

  /** What a number is for; each has a sequence of its own. */
  public enum Channel {
    PITCH,
    ROLL,
    ACCELERATION_X,
    ACCELERATION_Y,
    ACCELERATION_Z,
    BAROMETER,
    BAROMETER_OFFSET,
    TOF,
    HEIGHT_OFFSET,
    YAW_DRIFT,
    VELOCITY,
    STATE_PERIOD,
    DRIFT,
    LINK_LOSS,
    LINK_DELAY,
    LINK_DUPLICATE,
    LINK_REORDER,
    LINK_CORRUPT,
    LINK_BYTES,
    MOVE_X,
    MOVE_Y,
    MOVE_Z,
    MOVE_HEADING,
    BOARD_TOF,
    REFUSED_MOVE
  }

  private final long seed;

  /**
   * @param seed of the whole simulation
   * @param drone its number, from 1
   */
  public SeededNoise(long seed, int drone) {
    this(mixed(mixed(seed) + drone));
  }

  private SeededNoise(long mixedSeed) {
    this.seed = mixedSeed;
  }

  /** Other numbers for the same purposes, of a part of the drone that has a name. */
  public SeededNoise of(String part) {
    return new SeededNoise(mixed(seed + part.hashCode()));
  }

  /** A number of the standard normal distribution. */
  public double gaussian(Channel channel, long index) {
    return random(channel, index).nextGaussian();
  }

  /** A number from {@code least} to {@code most}, evenly distributed. */
  public double between(double least, double most, Channel channel, long index) {
    return least + (most - least) * random(channel, index).nextDouble();
  }

  private Random random(Channel channel, long index) {
    return new Random(mixed(mixed(seed + channel.name().hashCode()) + index));
  }

  /** The finalizer of SplitMix64 (Steele, Lea, Flood 2014): spreads close numbers far apart. */
  private static long mixed(long value) {
    long z = value + 0x9e3779b97f4a7c15L;
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }
}
