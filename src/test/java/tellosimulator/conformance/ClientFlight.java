package tellosimulator.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.testing.Jvm;
import tellosimulator.testing.Tool;

/** A run of {@code conformance/run.py}, whose output is part of the build's output. */
final class ClientFlight {

  /** A client, a tool or the jar is missing. Source: {@code run.py}. */
  private static final int MISSING = 77;

  /** The kernel does not allow private networks. Source: {@code run.py}. */
  private static final int FORBIDDEN = 78;

  private static final boolean MUST_FLY = "true".equals(System.getenv("CI"));

  private ClientFlight() {}

  /**
   * Flies, and fails unless everything succeeded; skips the test if the client cannot fly here.
   *
   * @param arguments of {@code run.py}
   */
  static void fly(String... arguments) throws IOException, InterruptedException {
    Process flight = Tool.PYTHON.command(words(arguments)).redirectErrorStream(true).start();
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
      case MISSING -> cannotFly(output.strip());
      case FORBIDDEN -> abort(output);
      default -> assertEquals(0, exitCode, output);
    }
  }

  /**
   * Flies {@code examples/FirstFlight.java} to the address of a real drone, and fails unless it
   * lands.
   *
   * @param options of {@code run}
   */
  static void flyFirstFlight(String... options) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(Jvm.java(), "-jar", jar(), "run"));
    command.addAll(List.of(options));
    command.addAll(List.of("--headless", "--time-factor", "max", "--", Jvm.java()));
    command.addAll(List.of("examples/FirstFlight.java", "192.168.10.1", "8889"));
    Process run = Jvm.process(command).redirectErrorStream(true).start();
    try {
      String printed = new String(run.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertEquals(0, run.waitFor(), printed);
      assertTrue(printed.contains("`land` answered `ok`"), printed);
      assertEquals(List.of(options).contains("--shim"), printed.contains("127.0.0.1"), printed);
    } finally {
      run.descendants().forEach(ProcessHandle::destroy);
      run.destroy();
    }
  }

  private static String[] words(String... arguments) {
    List<String> words =
        new ArrayList<>(List.of("conformance/run.py", "--java", Jvm.java(), "--jar", jar()));
    words.addAll(List.of(arguments));
    return words.toArray(String[]::new);
  }

  /** Returns the path of the tested jar. */
  static String jar() {
    return System.getProperty("simulator.jar", "target/tello-simulator.jar");
  }

  /** Skips the test, or fails it where all tools must be installed. */
  private static void cannotFly(String reason) {
    if (MUST_FLY) {
      fail(reason);
    }
    abort(reason);
  }
}
