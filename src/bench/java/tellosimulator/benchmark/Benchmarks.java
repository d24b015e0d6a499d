package tellosimulator.benchmark;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Measures what the project promises and prints one table: {@code mvn -Pbenchmark verify}, or
 * faster {@code mvn -Pbenchmark -Dbenchmark.minutes=1 verify}, or only a part of it {@code mvn
 * -Pbenchmark -Dbenchmark.only=video verify}.
 */
public final class Benchmarks {

  private static final String DEFAULT_MINUTES = "10";

  /** Some rows of the table. */
  @FunctionalInterface
  private interface Part {
    List<Measurement> rows(double minutes) throws IOException;
  }

  private Benchmarks() {}

  /** Runs everything; takes the time of the three long flights and seven minutes. */
  public static void main(String[] args) throws IOException {
    double minutes = Double.parseDouble(System.getProperty("benchmark.minutes", DEFAULT_MINUTES));
    List<Measurement> rows = new ArrayList<>();
    for (Part part : chosen(System.getProperty("benchmark.only", ""))) {
      rows.addAll(part.rows(minutes));
    }
    System.out.printf(
        "Java %s, %s, %d processors%n%n",
        System.getProperty("java.version"),
        System.getProperty("os.name"),
        Runtime.getRuntime().availableProcessors());
    Measurement.print(rows, System.out);
  }

  /**
   * @param only names of parts with commas between them; all if empty
   */
  private static List<Part> chosen(String only) {
    Map<String, Part> parts = parts();
    if (only.isEmpty()) {
      return List.copyOf(parts.values());
    }
    List<String> names = List.of(only.split(","));
    if (!parts.keySet().containsAll(names)) {
      throw new IllegalArgumentException(
          "benchmark.only is " + only + ", but must be of " + parts.keySet());
    }
    return names.stream().map(parts::get).toList();
  }

  private static Map<String, Part> parts() {
    Map<String, Part> parts = new LinkedHashMap<>();
    parts.put("speed", minutes -> SpeedBenchmark.all());
    parts.put("sticks", minutes -> SticksBenchmark.all());
    parts.put("scenario", minutes -> ScenarioBenchmark.all());
    parts.put("wire", minutes -> wire());
    parts.put("video", minutes -> VideoBenchmark.all());
    parts.put("stream", StreamBenchmark::all);
    parts.put("start", minutes -> WireBenchmark.start());
    parts.put("memory", WireBenchmark::memoryAfter);
    parts.put("window", WindowBenchmark::all);
    parts.put("recording", minutes -> RecordingBenchmark.all());
    parts.put("proxy", minutes -> ProxyBenchmark.all());
    parts.put("kit", minutes -> KitBenchmark.all());
    parts.put("report", minutes -> ReportBenchmark.all());
    parts.put("image", ImageBenchmark::all);
    return parts;
  }

  private static List<Measurement> wire() throws IOException {
    List<Measurement> rows = new ArrayList<>();
    rows.addAll(WireBenchmark.queries(false));
    rows.addAll(WireBenchmark.stateLines(false));
    rows.addAll(WireBenchmark.queries(true));
    rows.addAll(WireBenchmark.stateLines(true));
    return rows;
  }
}
