package tellosimulator.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The app image beside the runnable jar: how soon it is ready, and what memory it keeps. Where no
 * app image was made there are no rows of it.
 */
final class ImageBenchmark {

  private static final int STARTS = 9;

  private static final double MEGABYTE = 1 << 20;

  private ImageBenchmark() {}

  static List<Measurement> all(double minutes) throws IOException {
    List<Measurement> rows = new ArrayList<>();
    Path image = Path.of(System.getProperty("simulator.image", ""));
    boolean made = Files.isExecutable(launcher(image));
    if (made) {
      rows.addAll(starts(launcher(image)));
      rows.addAll(packed(image));
    }
    rows.add(afterFilm("jar", 150, minutes, Simulator::new));
    if (made) {
      rows.add(
          afterFilm("image", 120, minutes, options -> Simulator.ofImage(launcher(image), options)));
    }
    return rows;
  }

  private static Path launcher(Path image) {
    return image.resolve("bin").resolve("tello-simulator");
  }

  /** How one starts a simulator with options. */
  @FunctionalInterface
  private interface Start {
    Simulator with(String... options) throws IOException;
  }

  private static List<Measurement> starts(Path launcher) throws IOException {
    List<Double> jar = new ArrayList<>();
    List<Double> image = new ArrayList<>();
    List<Double> megabytes = new ArrayList<>();
    for (int i = 0; i < STARTS; i++) {
      try (Simulator simulator = new Simulator("--command-port", "0")) {
        jar.add(simulator.startSeconds());
      }
      try (Simulator simulator = Simulator.ofImage(launcher, "--command-port", "0")) {
        image.add(simulator.startSeconds());
        megabytes.add(simulator.figures().residentMegabytes());
      }
    }
    double jarMs = 1000 * new Statistics(jar).median();
    double imageMs = 1000 * new Statistics(image).median();
    return List.of(
        Measurement.beside(
            "Jar: from its start to `ready`, median of " + STARTS + " in turns",
            String.format(Locale.ROOT, "%.0f ms", jarMs)),
        Measurement.atMost(
            "Image: from its start to `ready`, of the jar's time", 50, 100 * imageMs / jarMs, "%"),
        Measurement.beside("…", String.format(Locale.ROOT, "%.0f ms", imageMs)),
        Measurement.atMost(
            "Image: resident memory at `ready`, largest of " + STARTS,
            90,
            new Statistics(megabytes).quantile(1),
            "MB"));
  }

  private static List<Measurement> packed(Path image) throws IOException {
    List<Measurement> rows = new ArrayList<>();
    try (var files = Files.newDirectoryStream(image.getParent(), "*.{tar.gz,zip,deb}")) {
      for (Path file : files) {
        rows.add(
            Measurement.atMost(
                "Image packed, " + file.getFileName(), 90, Files.size(file) / MEGABYTE, "MB"));
      }
    }
    return rows;
  }

  /** Resident memory after a flight with film and {@code rc}. */
  private static Measurement afterFilm(String what, double target, double minutes, Start start)
      throws IOException {
    try (VideoSocket video = new VideoSocket();
        Simulator simulator = start.with("--command-port", "0", "--video-port", "" + video.port());
        Operator operator = new Operator(simulator.port(1));
        Circling circling = new Circling(simulator.port(1))) {
      circling.startWithFilm(operator, video);
      video.picturesUntil(System.nanoTime() + (long) (minutes * 60e9));
      return Measurement.atMost(
          String.format(
              Locale.ROOT,
              "Resident memory after %.0f minutes of flight with film, %s",
              minutes,
              what),
          target,
          simulator.figures().residentMegabytes(),
          "MB");
    }
  }
}
