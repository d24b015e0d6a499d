package tellosimulator.endurance;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import tellosimulator.benchmark.ProcessFigures;

/**
 * Where a program runs: this machine, or one of a {@link PrivateNetwork}.
 *
 * @param wayIn what stands before a command so that it runs there
 * @param address under which others reach it
 */
record Host(List<String> wayIn, String address) {

  static final Host HERE = new Host(List.of(), "127.0.0.1");

  /** Starts a command there. */
  Program start(List<String> command) throws IOException {
    List<String> all = new ArrayList<>(wayIn);
    all.addAll(command);
    return new Program(all);
  }

  /** Starts one of this package's programs there, with little memory of its own. */
  Program start(Class<?> main, Object... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.addAll(List.of(ProcessFigures.tool("java"), "-Xmx128m", "-XX:+UseSerialGC", "-cp"));
    command.addAll(List.of(System.getProperty("java.class.path"), main.getName()));
    Arrays.stream(arguments).map(String::valueOf).forEach(command::add);
    return start(command);
  }

  /** Starts a script of the folder {@code src/bench/resources/endurance} there. */
  Program python(String script, Object... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of("python3", "-u", scriptFile(script).toString()));
    Arrays.stream(arguments).map(String::valueOf).forEach(command::add);
    return start(command);
  }

  private static Path scriptFile(String name) throws IOException {
    try {
      return Path.of(Host.class.getResource("/endurance/" + name).toURI());
    } catch (java.net.URISyntaxException e) {
      throw new IOException(name + " cannot be found", e);
    }
  }

  /** Runs a short command there, which must succeed. */
  void run(String... command) throws IOException {
    try (Program program = start(List.of(command))) {
      if (program.awaitExit(10) != 0) {
        throw new IOException(String.join(" ", command) + ": " + program.errors());
      }
    }
  }
}
