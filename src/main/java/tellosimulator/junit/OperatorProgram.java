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
 * A program in any language that flies a drone. The program runs as a process with captured output.
 * At the time limit, it is killed with all its descendants. Not thread-safe.
 */
public final class OperatorProgram {

  /**
   * Number of output lines in a failure message. Decided: enough for a Python stack trace and the
   * lines before it.
   */
  private static final int SHOWN_LINES = 40;

  /** Maximum time to wait for a killed program to end. Decided: longer than any system needs. */
  private static final Duration PATIENCE = Duration.ofSeconds(10);

  private static final Pattern PLACEHOLDER = Pattern.compile("\\{[A-Za-z]+}");

  private final List<String> command;
  private final SimulatedDrone drone;
  private final Consumer<OperatorProgram> started;
  private Duration limit = Duration.ofSeconds(60);
  private Path directory = Path.of("").toAbsolutePath();
  private String output = "";

  /**
   * Creates a program that has not been run yet.
   *
   * @param started notified when the program is run
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
              + Spelling.hint(
                  word, values.keySet(), ", but only " + String.join(", ", values.keySet())));
    }
    String filled = word;
    for (Map.Entry<String, String> value : values.entrySet()) {
      filled = filled.replace(value.getKey(), value.getValue());
    }
    return filled;
  }

  /**
   * Sets the time limit, in wall clock time. At the limit, the program is killed. The default is
   * one minute.
   */
  public OperatorProgram within(Duration newLimit) {
    limit = newLimit;
    return this;
  }

  /**
   * Sets the working directory. The default is the test's own working directory.
   *
   * @throws IllegalArgumentException if the folder does not exist
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
   * Runs the program until it ends.
   *
   * @return this program, with its output
   * @throws AssertionError if the program cannot be started, was killed, or ended with an exit code
   *     other than 0; the message contains the last lines of its output
   */
  public OperatorProgram run() {
    int exit = exitCode();
    if (exit != 0) {
      throw failure("ended with exit code " + exit);
    }
    return this;
  }

  /**
   * Runs the program until it ends, and accepts any exit code.
   *
   * @return the exit code
   * @throws AssertionError if the program cannot be started or was killed; the message contains the
   *     last lines of its output
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
      process.getOutputStream().close(); // the program gets no input
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

  /** Kills the process with all its descendants, and waits until it has ended. */
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

  /** Returns the command line. */
  @Override
  public String toString() {
    return String.join(" ", command);
  }

  /** Returns the standard output and standard error of the program. */
  public String output() {
    return output;
  }
}
