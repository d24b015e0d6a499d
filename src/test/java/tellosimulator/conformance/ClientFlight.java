package tellosimulator.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** One run of {@code conformance/run.py}, whose lines go to the output of the build. */
final class ClientFlight {

  /** A client, a tool or the jar is missing. Source: {@code run.py}. */
  private static final int MISSING = 77;

  /** The kernel lets nobody make a private network. Source: {@code run.py}. */
  private static final int FORBIDDEN = 78;

  private static final boolean MUST_FLY = "true".equals(System.getenv("CI"));

  private ClientFlight() {}

  /**
   * Flies, and fails unless all went well; skips the test if the client cannot fly here.
   *
   * @param arguments of {@code run.py}
   */
  static void fly(String... arguments) throws IOException, InterruptedException {
    Process flight;
    try {
      flight = new ProcessBuilder(command(arguments)).redirectErrorStream(true).start();
    } catch (IOException e) {
      cannotFly("python3 is missing: " + e.getMessage());
      return;
    }
    String output;
    int exitCode;
    try {
      output = new String(flight.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      exitCode = flight.waitFor();
    } finally {
      flight.destroy();
    }
    System.out.print(output);
    switch (exitCode) {
      case MISSING -> cannotFly(output);
      case FORBIDDEN -> abort(output);
      default -> assertEquals(0, exitCode, output);
    }
  }

  private static List<String> command(String... arguments) {
    List<String> command = new ArrayList<>();
    command.addAll(List.of("python3", "conformance/run.py", "--java", java(), "--jar", jar()));
    command.addAll(Arrays.asList(arguments));
    return command;
  }

  /** The program that is flown. */
  static String jar() {
    return System.getProperty("simulator.jar", "target/tello-simulator.jar");
  }

  /** The Java that runs it. */
  static String java() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  /** Skips the test; fails it where all must be installed. */
  static void cannotFly(String reason) {
    if (MUST_FLY) {
      fail(reason);
    }
    abort(reason);
  }
}
