package tellosimulator.endurance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import tellosimulator.benchmark.Measurement;

/**
 * What other programs take of the machine's processors, from when this is made on. Where that is
 * much, times say nothing about the simulator. Linux tells it (proc(5), {@code /proc/stat} and
 * {@code /proc/PID/stat}); elsewhere it is taken to be nothing.
 */
final class OtherLoad {

  /** With more than this the machine is not free for the trial. Decided. */
  private static final double MOST = 0.15;

  /** Units of both files [1/s]; sysconf(_SC_CLK_TCK) has been 100 on Linux for long. */
  private static final double TICKS = 100;

  private static final Path MACHINE = Path.of("/proc/stat");

  /** Fields of the machine's line: user, nice, system, and steal, which went to other machines. */
  private static final List<Integer> BUSY = List.of(1, 2, 3, 8);

  /** Fields of a process behind its name: user, system, and the same of children that ended. */
  private static final List<Integer> USED = List.of(11, 12, 13, 14);

  private final long begunNanos = System.nanoTime();
  private final double busy = busySeconds();
  private final double own = ownSeconds();

  /** The share of all processors, from 0 to 1. */
  double share() {
    double seconds = (System.nanoTime() - begunNanos) * 1e-9;
    double others = busySeconds() - busy - (ownSeconds() - own);
    return Math.max(0, others / (seconds * Runtime.getRuntime().availableProcessors()));
  }

  /** A row about times or memory, which counts only where the machine was free. */
  static Measurement judged(Measurement row, double share) {
    return row.reached() || share <= MOST
        ? row
        : new Measurement(
            row.what(),
            row.target(),
            String.format(
                Locale.ROOT,
                "%s (not judged: others took %.0f %% of the processors)",
                row.measured(),
                100 * share),
            true);
  }

  private static double busySeconds() {
    return sum(MACHINE, 0, BUSY);
  }

  /** Of this process and all that it has started. */
  private static double ownSeconds() {
    ProcessHandle self = ProcessHandle.current();
    return Stream.concat(Stream.of(self), self.descendants())
        .mapToDouble(process -> sum(Path.of("/proc/" + process.pid() + "/stat"), ')', USED))
        .sum();
  }

  /**
   * The sum of fields of a file's first line [s]; 0 if there is no such file, or no longer.
   *
   * @param after the character behind which fields are counted from 0; 0 for the whole line
   */
  private static double sum(Path file, int after, List<Integer> fields) {
    try (Stream<String> lines = Files.lines(file)) {
      String line = lines.findFirst().orElse("");
      String[] words = line.substring(line.lastIndexOf(after) + 1).trim().split("\\s+", -1);
      return fields.stream().mapToDouble(field -> Double.parseDouble(words[field])).sum() / TICKS;
    } catch (IOException e) {
      return 0;
    }
  }
}
