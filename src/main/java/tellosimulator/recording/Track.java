package tellosimulator.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The recorded motion of a drone. Immutable.
 *
 * @param drone the drone's number, from 1
 * @param samples the samples in order of time; at least one
 */
public record Track(int drone, List<Sample> samples) {

  public Track {
    samples = List.copyOf(samples);
    if (samples.isEmpty()) {
      throw new IllegalArgumentException("samples are none, but there must be at least one");
    }
  }

  /** Returns the latest sample that is not after a time; the first sample if there is none. */
  public Sample at(double time) {
    return samples.get(indexAt(time));
  }

  /**
   * Returns the next sample after a sample of this track; for the last sample, the sample itself.
   */
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

  /** Collects the samples of drones, and thins out the samples of long flights. Not thread-safe. */
  static final class Builder {

    /**
     * Maximum number of samples for each drone. When it is exceeded, every second sample is
     * dropped. Decided: flights of up to 2.7 hours keep all their samples; the samples of one drone
     * take up to 50 MB.
     */
    private static final int MOST = 200_000;

    private static final class Samples {
      private List<Sample> kept = new ArrayList<>();
      private long count;
      private int stride = 1;
      private Sample last;

      private void add(Sample sample) {
        last = sample;
        if (count % stride == 0) {
          kept.add(sample);
          if (kept.size() > MOST) {
            thin();
          }
        }
        count++;
      }

      private void thin() {
        List<Sample> fewer = new ArrayList<>();
        for (int i = 0; i < kept.size(); i += 2) {
          fewer.add(kept.get(i));
        }
        kept = fewer;
        stride *= 2;
      }

      private Track track(int drone) {
        if (kept.get(kept.size() - 1).time() < last.time()) {
          kept.add(last);
        }
        return new Track(drone, kept);
      }
    }

    private final Map<Integer, Samples> drones = new TreeMap<>();

    void add(int drone, Sample sample) {
      drones.computeIfAbsent(drone, number -> new Samples()).add(sample);
    }

    /** The tracks of all drones, in order of their numbers. */
    List<Track> tracks() {
      return drones.entrySet().stream()
          .map(entry -> entry.getValue().track(entry.getKey()))
          .toList();
    }
  }
}
