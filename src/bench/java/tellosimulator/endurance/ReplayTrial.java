package tellosimulator.endurance;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Measurement;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.replay.LongFlight;
import tellosimulator.replay.Repetition;

/** A recording of a day that is flown again; it takes a gigabyte of disk for a while. */
final class ReplayTrial {

  private static final double HOURS = 24;

  private ReplayTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    try (TemporaryFolder folder = TemporaryFolder.create("day")) {
      long begun = System.nanoTime();
      Repetition repetition = LongFlight.repeat(HOURS, folder.path());
      double seconds = (System.nanoTime() - begun) * 1e-9;
      repetition.differences().forEach(System.out::println);
      return List.of(
          new Measurement(
              "A recording of 24 simulated hours, flown again",
              "identical to the byte",
              String.format(
                  Locale.ROOT,
                  "%d files differ, %.0f MB of wire, %.0f s for both",
                  repetition.differences().size(),
                  Files.size(repetition.recording().resolve("wire.jsonl")) * 1e-6,
                  seconds),
              repetition.identical() && repetition.remarks().isEmpty()));
    } catch (UnreadableRecordingException e) {
      throw new IOException(e);
    }
  }
}
