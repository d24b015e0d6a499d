package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import tellosimulator.benchmark.Measurement;
import tellosimulator.junit.KitClasses;

/** Many classes of tests at the same time, in several processes with several threads each. */
final class KitTrial {

  private static final int PROCESSES = 4;
  private static final int RUNS = 20;

  /** On each thread: two of them in four processes make two hundred. */
  private static final int CLASSES = 25;

  private static final double PATIENCE_SECONDS = 120;

  /** Descriptors that a JVM may open for itself meanwhile. */
  private static final int OTHER_DESCRIPTORS = 10;

  private KitTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    List<Program> programs = new ArrayList<>();
    try {
      for (int i = 0; i < PROCESSES; i++) {
        programs.add(Host.HERE.start(KitClasses.class, RUNS, CLASSES));
      }
      int classes = 0;
      int failures = 0;
      int threads = 0;
      int descriptors = 0;
      for (int run = 0; run < RUNS; run++) {
        for (Program program : programs) {
          String[] told = program.await("run", PATIENCE_SECONDS).split(" ", -1);
          classes += Integer.parseInt(told[1]);
          failures += Integer.parseInt(told[2]);
          threads = Math.max(threads, Integer.parseInt(told[3]));
          descriptors = Math.max(descriptors, Integer.parseInt(told[4]));
        }
      }
      return List.of(
          new Measurement(
              "Classes of tests in 4 processes with 2 threads each, that pass",
              "all of " + PROCESSES * 2 * CLASSES * RUNS,
              (classes - failures) + " of " + classes,
              failures == 0 && classes == PROCESSES * 2 * CLASSES * RUNS),
          new Measurement("… threads left", "0", Integer.toString(threads), threads <= 0),
          new Measurement(
              "… descriptors left, some the JVM's own",
              "at most " + OTHER_DESCRIPTORS,
              Integer.toString(descriptors),
              descriptors <= OTHER_DESCRIPTORS));
    } finally {
      programs.forEach(Program::close);
    }
  }
}
