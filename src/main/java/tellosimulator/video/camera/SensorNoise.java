package tellosimulator.video.camera;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.SplittableRandom;
import tellosimulator.model.DroneState;

/**
 * Adds the noise of an image sensor to luma. The noise depends only on the seed, the drone and the
 * simulated time, so a repeated flight gives the same video.
 */
final class SensorNoise {

  /**
   * Maximum deviation [steps of luma]. Decided: just visible on a plain wall, and small enough that
   * the encoder removes most of it.
   */
  private static final int AMPLITUDE = 1;

  /** Eight pixels that all have the maximum deviation. */
  private static final long OFFSET = AMPLITUDE * 0x0101010101010101L;

  /** Number of consecutive blocks of eight pixels to which consecutive samples are added. */
  private static final int RUN = 64;

  private static final int STARTS = 1 << 13;

  private static final VarHandle BLOCK =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

  /**
   * Samples of noise. Each sample holds the values for eight pixels, with a triangular distribution
   * from 0 to twice the amplitude.
   */
  private static final long[] SAMPLES = samples();

  private SensorNoise() {}

  private static long[] samples() {
    SplittableRandom random = new SplittableRandom(0);
    long[] samples = new long[STARTS + RUN];
    for (int i = 0; i < Long.BYTES * samples.length; i++) {
      int noise = random.nextInt(AMPLITUDE + 1) + random.nextInt(AMPLITUDE + 1);
      samples[i / Long.BYTES] = samples[i / Long.BYTES] << Byte.SIZE | noise;
    }
    return samples;
  }

  /**
   * Adds noise to the first pixels of a picture. Luma is from 16 to 235, so no sum carries over to
   * the next pixel.
   *
   * @param seed the seed of the simulation
   * @param drone the drone whose camera took the picture
   */
  static void addTo(byte[] luma, int pixels, long seed, DroneState drone) {
    SplittableRandom random =
        new SplittableRandom(seed ^ (long) drone.drone() << 48 ^ drone.time().nanos());
    int blocks = pixels / Long.BYTES;
    for (int from = 0; from < blocks; from += RUN) {
      addRun(luma, from, Math.min(blocks, from + RUN), random.nextInt(STARTS) - from);
    }
  }

  private static void addRun(byte[] luma, int from, int to, int shift) {
    for (int i = from; i < to; i++) {
      long block = (long) BLOCK.get(luma, i * Long.BYTES);
      BLOCK.set(luma, i * Long.BYTES, block + SAMPLES[i + shift] - OFFSET);
    }
  }
}
