package tellosimulator.recording;

import java.util.List;

/**
 * How a drone moved. Immutable; for any thread.
 *
 * @param drone its number, from 1
 * @param samples in the order of time; at least one
 */
public record Track(int drone, List<Sample> samples) {

  public Track {
    samples = List.copyOf(samples);
    if (samples.isEmpty()) {
      throw new IllegalArgumentException("samples are none, but there must be at least one");
    }
  }

  /** The last sample until a moment, or else the first one. */
  public Sample at(double time) {
    return samples.get(indexAt(time));
  }

  /** The sample that follows a sample of this track; the last one is followed by itself. */
  Sample after(Sample sample) {
    return samples.get(Math.min(samples.size() - 1, indexAt(sample.time()) + 1));
  }

  private int indexAt(double time) {
    int low = 0;
    int high = samples.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) / 2;
      if (samples.get(middle).time() <= time) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
}
