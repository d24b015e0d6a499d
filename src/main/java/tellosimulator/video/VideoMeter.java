package tellosimulator.video;

import java.util.ArrayDeque;
import java.util.Deque;

/** Measures the figures of a stream. Not thread-safe. */
final class VideoMeter {

  private static final long WINDOW = 1_000_000_000L;

  /**
   * The measurements for one picture.
   *
   * @param moment when the picture was rendered [ns]
   * @param bytes its encoded size [bytes]; 0 if it was not encoded
   * @param film the time to render it [ns]
   * @param encode the time to encode it [ns]
   */
  record Sample(long moment, int bytes, long film, long encode) {}

  private final Deque<Sample> samples = new ArrayDeque<>();

  /** Adds a picture and returns the figures of the last second. */
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

  /** Resets the meter for a new stream. */
  void restart() {
    samples.clear();
  }
}
