package tellosimulator.sensor;

import java.util.Random;

/**
 * Random numbers that depend only on seed, drone, purpose and index. The numbers are therefore the
 * same however often a sensor is read. Immutable.
 */
public final class SeededNoise {

  /** The purpose of a random number. Each purpose has its own sequence. */
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
   * Creates the noise of a drone.
   *
   * @param seed the seed of the whole simulation
   * @param drone the number of the drone, from 1
   */
  public SeededNoise(long seed, int drone) {
    this(mixed(mixed(seed) + drone));
  }

  private SeededNoise(long mixedSeed) {
    this.seed = mixedSeed;
  }

  /**
   * Returns the noise for a named part of the drone. Its numbers differ from those of the drone
   * itself.
   */
  public SeededNoise of(String part) {
    return new SeededNoise(mixed(seed + part.hashCode()));
  }

  /** Returns a random number from the standard normal distribution. */
  public double gaussian(Channel channel, long index) {
    return random(channel, index).nextGaussian();
  }

  /** Returns a random number from {@code least} to {@code most}, uniformly distributed. */
  public double between(double least, double most, Channel channel, long index) {
    return least + (most - least) * random(channel, index).nextDouble();
  }

  private Random random(Channel channel, long index) {
    return new Random(mixed(mixed(seed + channel.name().hashCode()) + index));
  }

  /**
   * Applies the finalizer of SplitMix64 (Steele, Lea, Flood 2014), which maps similar numbers to
   * very different ones.
   */
  private static long mixed(long value) {
    long z = value + 0x9e3779b97f4a7c15L;
    z = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    z = (z ^ (z >>> 27)) * 0x94d049bb133111ebL;
    return z ^ (z >>> 31);
  }
}
