package tellosimulator.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;

/** How long it takes to read a scenario with a thousand obstacles. */
final class ScenarioBenchmark {

  private static final int OBSTACLES = 1000;
  private static final int RUNS = 11;
  private static final double TARGET_MS = 500;

  /** Boxes of half a metre in a hall of 200 by 200 m, two metres apart. */
  private static final int IN_A_ROW = 40;

  private static final int APART_CM = 200;

  private ScenarioBenchmark() {}

  /** The first time, with all code still to be loaded, and the usual time. */
  static List<Measurement> all() throws IOException {
    Path file = Files.createTempFile("thousand", ".yaml");
    try {
      Files.writeString(file, text());
      double first = read(file);
      List<Double> later = new ArrayList<>();
      for (int i = 0; i < RUNS; i++) {
        later.add(read(file));
      }
      return List.of(
          Measurement.atMost(
              "Reading a scenario of " + OBSTACLES + " obstacles for the first time",
              TARGET_MS,
              first),
          Measurement.atMost("… median of " + RUNS, TARGET_MS, new Statistics(later).median()));
    } finally {
      Files.delete(file);
    }
  }

  private static double read(Path file) {
    long start = System.nanoTime();
    try {
      int obstacles = ScenarioFile.read(file).config().arena().obstacles().size();
      if (obstacles != OBSTACLES) {
        throw new IllegalStateException(obstacles + " obstacles were read");
      }
    } catch (ScenarioException e) {
      throw new IllegalStateException(e);
    }
    return (System.nanoTime() - start) * 1e-6;
  }

  private static String text() {
    StringBuilder text =
        new StringBuilder("room: {width: 20000, depth: 20000, height: 1000}\nobstacles:\n");
    for (int i = 0; i < OBSTACLES; i++) {
      text.append(
          String.format(
              Locale.ROOT,
              "  - box: {name: box %d, at: [%d, %d], size: [50, 50, 100], heading: %d}%n",
              i,
              (i / IN_A_ROW + 1) * APART_CM,
              (i % IN_A_ROW - IN_A_ROW / 2) * APART_CM,
              i % 360));
    }
    return text.toString();
  }
}
