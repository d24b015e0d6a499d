package tellosimulator.benchmark;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * Measures what the project promises and prints one table: {@code mvn -Pbenchmark verify}, or
 * faster {@code mvn -Pbenchmark -Dbenchmark.minutes=1 verify}.
 */
public final class Benchmarks {

  private static final String DEFAULT_MINUTES = "10";

  private Benchmarks() {}

  /** Runs everything; takes the time of the three long flights and five minutes. */
  public static void main(String[] args) throws IOException {
    double minutes = Double.parseDouble(System.getProperty("benchmark.minutes", DEFAULT_MINUTES));
    List<Row> rows = new ArrayList<>();
    rows.addAll(SpeedBenchmark.all());
    rows.addAll(WireBenchmark.queries(false));
    rows.addAll(WireBenchmark.stateLines(false));
    rows.addAll(WireBenchmark.queries(true));
    rows.addAll(WireBenchmark.stateLines(true));
    rows.addAll(StreamBenchmark.all(minutes));
    rows.addAll(WireBenchmark.start());
    rows.addAll(WireBenchmark.memoryAfter(minutes));
    rows.addAll(WindowBenchmark.all(minutes));
    System.out.printf(
        "Java %s, %s, %d processors%n%n",
        System.getProperty("java.version"),
        System.getProperty("os.name"),
        Runtime.getRuntime().availableProcessors());
    System.out.println("| what | target | measured | reached |");
    System.out.println("|---|---|---|---|");
    rows.forEach(row -> System.out.println(row.markdown()));
  }
}
