package tellosimulator.launcher;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import tellosimulator.launcher.Confinement.Limits;
import tellosimulator.time.RealTimer;

/**
 * Checks whether a confined program exceeds its limits. The kernel has no limit on the processes or
 * the memory of a namespace where control groups cannot be written. Confined to the thread of its
 * run.
 */
final class LimitWatch {

  /**
   * The memory that belongs to a process, without files and programs, which the kernel can drop.
   * Memory that processes share counts for each of them. Documented: proc_pid_status(5).
   */
  private static final List<String> OWN = List.of("RssAnon:", "RssShmem:");

  private final Limits limits;
  private final RealTimer watch = new RealTimer();

  LimitWatch(Limits limits) {
    this.limits = limits;
  }

  /**
   * Returns the limit that a program exceeds, if there is one.
   *
   * @param printed the size of its output so far [bytes]
   */
  Optional<ExceededLimit> exceeded(Process flying, long printed) {
    List<ProcessHandle> processes = flying.descendants().toList();
    if (watch.seconds() >= limits.seconds()) {
      return Optional.of(ExceededLimit.TIME);
    }
    if (printed > 10L * limits.outputBytes()) {
      return Optional.of(ExceededLimit.OUTPUT);
    }
    if (processes.size() - 1 > limits.processes()) { // the first one is that of the namespace
      return Optional.of(ExceededLimit.PROCESSES);
    }
    long resident = processes.stream().mapToLong(LimitWatch::resident).sum();
    return resident > (long) limits.memoryMb() << 20
        ? Optional.of(ExceededLimit.MEMORY)
        : Optional.empty();
  }

  /** Returns the resident memory of a process [bytes]; 0 if it has ended. */
  private static long resident(ProcessHandle process) {
    Path status = Path.of("/proc", Long.toString(process.pid()), "status");
    // The name of a process may be any bytes.
    try (Stream<String> lines = Files.lines(status, StandardCharsets.ISO_8859_1)) {
      return lines
              .filter(line -> OWN.stream().anyMatch(line::startsWith))
              .mapToLong(line -> Long.parseLong(line.replaceAll("[^0-9]", "")))
              .sum()
          << 10;
    } catch (IOException | UncheckedIOException e) {
      return 0;
    }
  }
}
