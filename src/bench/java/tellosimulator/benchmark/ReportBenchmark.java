package tellosimulator.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import tellosimulator.recording.RecordingFixture;

/** How long the report of a flight takes, and how large it is. */
final class ReportBenchmark {

  private static final int RUNS = 5;
  private static final double TARGET_MS = 3_000;
  private static final double MOST_MEGABYTES_A_MINUTE = 3;

  private ReportBenchmark() {}

  /** Of a minute and of ten, with the start of the program. */
  static List<Measurement> all() throws IOException {
    Path folder = Files.createTempDirectory("report");
    try {
      return List.of(
          Measurement.atMost(
              "Size of the report of a minute of flight",
              MOST_MEGABYTES_A_MINUTE,
              size(recorded(folder.resolve("1"), 1)),
              "MB"),
          Measurement.atMost(
              "Report of a flight of ten minutes, with the start of the program, median of " + RUNS,
              TARGET_MS,
              median(recorded(folder.resolve("10"), 10))),
          Measurement.beside(
              "… its size", String.format(Locale.ROOT, "%.1f MB", size(folder.resolve("10")))));
    } finally {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path each : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(each);
        }
      }
    }
  }

  /** A drone that circles at 80 cm and turns its nose with it; a refused command each 2 s. */
  private static Path recorded(Path folder, int minutes) {
    StringBuilder rows =
        new StringBuilder(
            "t_s,drone,x_cm,y_cm,z_cm,roll_deg,pitch_deg,heading_deg,phase,battery_pct\n");
    StringBuilder events = new StringBuilder();
    for (int i = 0; i < minutes * 60 * 20; i++) {
      double turned = i / 100.0;
      rows.append(
          String.format(
              Locale.ROOT,
              "%.3f,1,%.2f,%.2f,80.00,2.00,-3.00,%.2f,flying,90%n",
              i / 20.0,
              150 * Math.cos(turned),
              150 * Math.sin(turned),
              -Math.toDegrees(turned) % 180));
      if (i % 40 == 0) {
        String head = "{\"t\":" + i / 20.0 + ",\"drone\":1,\"command\":\"up 9\",\"kind\":";
        events.append(head).append("\"command\"}\n").append(head);
        events.append("\"refused\",\"reply\":\"out of range\",\"reason\":\"9 is below 20\"}\n");
      }
    }
    new RecordingFixture(folder)
        .run("{\"format\":1,\"started\":0,\"ended\":" + minutes * 60 + "}")
        .with("flight.csv", rows.toString().replace(System.lineSeparator(), "\n"))
        .with("events.jsonl", events.toString());
    return folder;
  }

  private static double median(Path recording) throws IOException {
    List<Double> times = new ArrayList<>();
    for (int i = 0; i < RUNS; i++) {
      long begun = System.nanoTime();
      report(recording);
      times.add((System.nanoTime() - begun) * 1e-6);
    }
    return new Statistics(times).median();
  }

  private static double size(Path recording) throws IOException {
    report(recording);
    return Files.size(recording.resolve("report.html")) * 1e-6;
  }

  private static void report(Path recording) throws IOException {
    try {
      String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
      int exitCode =
          new ProcessBuilder(
                  java, "-jar", System.getProperty("simulator.jar"), "report", recording.toString())
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(ProcessBuilder.Redirect.INHERIT)
              .start()
              .waitFor();
      if (exitCode != 0) {
        throw new IllegalStateException("the report ended with " + exitCode);
      }
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
