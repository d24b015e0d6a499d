package tellosimulator.conformance;

import static org.junit.jupiter.api.Assertions.assertEquals;
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
