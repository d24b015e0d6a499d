package tellosimulator.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** How long unit tests take that fly a simulated drone each. */
final class KitBenchmark {

  private static final int RUNS = 3;

  private KitBenchmark() {}

  /** What {@link KitFlights} prints. */
  private record Run(
      int tests, int failed, double firstMs, double totalMs, double flownMs, double seconds) {

    static Run of(String line) {
      String[] parts = line.split(" ", -1);
      return new Run(
          Integer.parseInt(parts[0]),
          Integer.parseInt(parts[1]),
          Double.parseDouble(parts[2]),
          Double.parseDouble(parts[3]),
          Double.parseDouble(parts[4]),
          Double.parseDouble(parts[5]));
    }

    double otherMsEach() {
      return (totalMs - flownMs) / tests;
    }
  }

  /** One JVM for each run. */
  static List<Measurement> all() throws IOException {
    List<Run> runs = new ArrayList<>();
    for (int i = 0; i < RUNS; i++) {
      runs.add(run());
    }
    List<Measurement> rows = new ArrayList<>();
    rows.add(
        Measurement.ofRuns(
            runs.stream()
                .map(
                    run ->
                        Measurement.atMost(
                            KitFlights.TESTS + " tests with a flight of 20 commands each, one JVM",
                            60,
                            run.failed == 0 ? run.totalMs / 1000 : Double.POSITIVE_INFINITY,
                            "s"))
                .toList()));
    rows.add(
        new Measurement(
            "… shortest flight of them",
            "at least " + KitFlights.SIMULATED_SECONDS + " simulated s",
            runs.get(0).seconds + " simulated s",
            runs.stream().allMatch(run -> run.seconds >= KitFlights.SIMULATED_SECONDS)));
    rows.add(
        Measurement.ofRuns(
            runs.stream()
                .map(
                    run ->
                        Measurement.atMost("… first test after the JVM's start", 700, run.firstMs))
                .toList()));
    rows.add(
        Measurement.ofRuns(
            runs.stream()
                .map(
                    run ->
                        Measurement.atMost(
                            "… each further one besides its flight", 30, run.otherMsEach()))
                .toList()));
    return rows;
  }

  private static Run run() throws IOException {
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                KitFlights.class.getName())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    List<String> lines = process.inputReader(Charset.defaultCharset()).lines().toList();
    try {
      if (process.waitFor() != 0) {
        throw new IllegalStateException("the tests ended with exit code " + process.exitValue());
      }
    } catch (InterruptedException e) {
      throw new UncheckedIOException(new IOException(e));
    }
    return Run.of(lines.get(lines.size() - 1));
  }
}
