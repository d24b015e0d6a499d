package tellosimulator.junit;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import tellosimulator.words.Spelling;

/**
 * A program in any language that flies a drone: a process whose output is kept, and which is killed
 * with all that it started when its time is over. For one thread.
 */
public final class OperatorProgram {

  /** Lines of output in a failure. Decided: a stack trace of Python and what led to it. */
  private static final int SHOWN_LINES = 40;

  /** How long a program that was killed may take to end. Decided: longer than any system needs. */
  private static final Duration PATIENCE = Duration.ofSeconds(10);

  private static final Pattern PLACEHOLDER = Pattern.compile("\\{[A-Za-z]+}");

  private final List<String> command;
  private final SimulatedDrone drone;
  private final Consumer<OperatorProgram> started;
  private Duration limit = Duration.ofSeconds(60);
  private Path directory = Path.of("").toAbsolutePath();
  private String output = "";

  /**
   * @param started is told when it is run
   * @throws IllegalArgumentException if a word is an unknown placeholder
   */
  OperatorProgram(List<String> command, SimulatedDrone drone, Consumer<OperatorProgram> started) {
    Map<String, String> values = placeholders(drone);
    this.command = command.stream().map(word -> filled(word, values)).toList();
    this.drone = drone;
    this.started = started;
  }

  private static Map<String, String> placeholders(SimulatedDrone drone) {
    Map<String, String> values = new LinkedHashMap<>();
    values.put("{host}", drone.host());
    values.put("{commandPort}", Integer.toString(drone.commandPort()));
    values.put("{statePort}", Integer.toString(drone.statePort()));
    values.put("{videoPort}", Integer.toString(drone.videoPort()));
    return values;
  }

  private static String filled(String word, Map<String, String> values) {
    if (PLACEHOLDER.matcher(word).matches() && !values.containsKey(word)) {
      throw new IllegalArgumentException(
          "there is no placeholder "
              + word
              + Spelling.meant(word, values.keySet())
                  .map(meant -> ", did you mean " + meant + "?")
                  .orElse(", but only " + String.join(", ", values.keySet())));
    }
    String filled = word;
    for (Map.Entry<String, String> value : values.entrySet()) {
      filled = filled.replace(value.getKey(), value.getValue());
    }
    return filled;
  }

  /** Kills it after so long by the wall clock; without this, after a minute. */
  public OperatorProgram within(Duration newLimit) {
    limit = newLimit;
    return this;
  }

  /**
   * Where it runs; without this, where the test does.
   *
   * @throws IllegalArgumentException if there is no such folder
   */
  public OperatorProgram in(Path newDirectory) {
    if (!Files.isDirectory(newDirectory)) {
      throw new IllegalArgumentException(
          "there is no folder " + newDirectory.toAbsolutePath() + " to run the program in");
    }
    directory = newDirectory;
    return this;
  }

  /**
   * Runs it to its end.
   *
   * @return itself, with its output
   * @throws AssertionError with the end of its output, if it cannot be started, if it was killed,
   *     or if its exit code is not 0
   */
  public OperatorProgram run() {
    int exit = exitCode();
    if (exit != 0) {
      throw failure("ended with exit code " + exit);
    }
    return this;
  }

  /**
   * Runs it to its end, whatever that is.
   *
   * @return its exit code
   * @throws AssertionError with the end of its output, if it cannot be started, or if it was killed
   */
  public int exitCode() {
    started.accept(this);
    try {
      Path kept = Files.createTempFile("operator", ".log");
      try {
        return run(kept);
      } finally {
        output = Files.readString(kept, Charset.defaultCharset());
        Files.delete(kept);
      }
    } catch (IOException e) {
      throw failure("could not be run: " + e.getMessage());
    }
  }

  private int run(Path kept) throws IOException {
    Process process =
        new ProcessBuilder(command)
            .directory(directory.toFile())
            .redirectErrorStream(true)
            .redirectOutput(kept.toFile())
            .start();
    try {
      process.getOutputStream().close(); // it has nothing to read
      if (!process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
        kill(process);
        output = Files.readString(kept, Charset.defaultCharset());
        throw failure(
            String.format(
                Locale.ROOT,
                "was killed, because it ran longer than %.1f s",
                limit.toMillis() / 1e3));
      }
      return process.exitValue();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw failure("was interrupted");
    } finally {
      kill(process);
    }
  }

  /** Ends it with all that it started, and waits until it has ended. */
  private static void kill(Process process) {
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly();
    try {
      process.waitFor(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private AssertionError failure(String what) {
    List<String> lines = output.lines().toList();
    List<String> last = lines.subList(Math.max(0, lines.size() - SHOWN_LINES), lines.size());
    return new AssertionError(
        String.format(
            Locale.ROOT,
            "%s for %s %s%s%s",
            this,
            drone,
            what,
            last.isEmpty() ? "" : System.lineSeparator(),
            String.join(System.lineSeparator(), last)));
  }

  /** Its command line. */
  @Override
  public String toString() {
    return String.join(" ", command);
  }

  /** What it wrote to standard output and standard error. */
  public String output() {
    return output;
  }
}
