package tellosimulator.video;

import java.util.ArrayDeque;
import java.util.Deque;

/** Measures a stream. For one thread. */
final class VideoMeter {

  private static final long WINDOW = 1_000_000_000L;

  /**
   * A picture that was made.
   *
   * @param moment when [ns]
   * @param bytes how large it is, 0 if it was not encoded
   * @param film how long it took to take it [ns]
   * @param encode how long it took to encode it [ns]
   */
  record Sample(long moment, int bytes, long film, long encode) {}

  private final Deque<Sample> samples = new ArrayDeque<>();

  /** Counts a picture, and says how the last second went. */
  VideoFigures count(Sample newest) {
    samples.addLast(newest);
    while (newest.moment - samples.getFirst().moment > WINDOW) {
      samples.removeFirst();
    }
    long bytes = 0;
    long film = 0;
    long encode = 0;
    for (Sample sample : samples) {
      bytes += sample.bytes;
      film += sample.film;
      encode += sample.encode;
    }
    Sample oldest = samples.getFirst();
    double seconds = Math.max(1, newest.moment - oldest.moment) / 1e9;
    double periods = samples.size() - 1;
    if (periods == 0) {
      return new VideoFigures(0, 0, film / 1e6, encode / 1e6);
    }
    return new VideoFigures(
        periods / seconds,
        (bytes - oldest.bytes) * 8 / seconds,
        film / 1e6 / samples.size(),
        encode / 1e6 / samples.size());
  }

  /** Forgets everything: a new stream begins. */
  void restart() {
    samples.clear();
  }
}
