package tellosimulator.world;

import java.util.Random;
import tellosimulator.math.Vec3;
import tellosimulator.time.SimTime;

/**
 * The motion of the air over time: the mean wind, and gusts that come and go. The same wind and
 * seed always give the same gusts. Immutable.
 */
public final class WindField {

  /**
   * Number of sine waves that form the gusts in each direction. Decided: enough waves that the
   * gusts do not appear to repeat.
   */
  private static final int WAVES = 5;

  /** Maximum period of a wave [s]. Assumed: a drone can compensate for such slow gusts. */
  private static final double LONGEST = 15;

  /** Minimum period of a wave [s]. Assumed: a drone cannot compensate for such short gusts. */
  private static final double SHORTEST = 1.5;

  private final Wind wind;
  private final double amplitude;
  private final Wave[] ahead;
  private final Wave[] aside;

  /** A sine wave with an angular frequency [rad/s] and a phase [rad]. */
  private record Wave(double rate, double phase) {
    double at(double seconds) {
      return StrictMath.sin(rate * seconds + phase);
    }
  }

  /**
   * Creates the field of a wind.
   *
   * @param seed the seed of the simulation
   */
  public WindField(Wind wind, long seed) {
    this.wind = wind;
    // the variance of a sine is half its amplitude squared, and variances add up
    this.amplitude = wind.gusts() * Math.sqrt(2.0 / WAVES);
    Random random = new Random(seed);
    this.ahead = waves(random);
    this.aside = waves(random);
  }

  private static Wave[] waves(Random random) {
    Wave[] waves = new Wave[WAVES];
    for (int i = 0; i < WAVES; i++) {
      double share = (i + random.nextDouble()) / WAVES;
      double period = LONGEST * StrictMath.pow(SHORTEST / LONGEST, share);
      waves[i] = new Wave(2 * Math.PI / period, 2 * Math.PI * random.nextDouble());
    }
    return waves;
  }

  /** Returns the velocity of the air, in the room frame [m/s]. */
  public Vec3 at(SimTime time) {
    if (amplitude == 0) {
      return wind.mean();
    }
    double seconds = time.seconds();
    return wind.mean().plus(new Vec3(sum(ahead, seconds), sum(aside, seconds), 0));
  }

  private double sum(Wave[] waves, double seconds) {
    double sum = 0;
    for (Wave wave : waves) {
      sum += wave.at(seconds);
    }
    return amplitude * sum;
  }
}
