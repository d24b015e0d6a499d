package tellosimulator.junit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** A program that runs simulators on several threads, as JUnit does with test classes. */
public final class KitClasses {

  private static final int THREADS = 2;
  private static final int PATIENCE_MS = 5000;

  private KitClasses() {}

  /**
   * Prints {@code classes failures threadsLeft descriptorsLeft} after each run.
   *
   * @param arguments the number of runs, and the number of consecutive simulators on each thread
   */
  public static void main(String[] arguments) throws IOException, InterruptedException {
    int runs = Integer.parseInt(arguments[0]);
    int each = Integer.parseInt(arguments[1]);
    once(); // loads what is never unloaded
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    long descriptors = descriptors();
    for (int run = 0; run < runs; run++) {
      List<Throwable> failures = run(each);
      failures.forEach(failure -> System.out.println("failed: " + failure));
      System.out.printf(
          "run %d %d %d %d%n",
          THREADS * each, failures.size(), left(before), descriptors() - descriptors);
    }
  }

  private static List<Throwable> run(int each) throws InterruptedException {
    List<Throwable> failures = new ArrayList<>();
    List<Thread> threads = new ArrayList<>();
    for (int i = 0; i < THREADS; i++) {
      Thread thread =
          new Thread(
              () -> {
                for (int j = 0; j < each; j++) {
                  try {
                    once();
                  } catch (IOException | RuntimeException | AssertionError e) {
                    synchronized (failures) {
                      failures.add(e);
                    }
                  }
                }
              });
      threads.add(thread);
      thread.start();
    }
    for (Thread thread : threads) {
      thread.join();
    }
    return failures;
  }

  /** Three tests of a class. */
  private static void once() throws IOException {
    try (TelloSimulator simulator = TelloSimulator.builder().drones(2).start()) {
      for (int test = 0; test < 3; test++) {
        simulator.reset();
        SimulatedDrone drone = simulator.drone(2);
        ScriptedOperator.fly(drone, "command", "takeoff", "forward 50", "land");
        if (drone.journal().commands().size() != 4 || !drone.truth().landed()) {
          throw new AssertionError(simulator.explanation());
        }
      }
    }
  }

  /** Counts the threads that were started since then and do not end. */
  private static int left(Set<Thread> before) throws InterruptedException {
    int left = 0;
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (!before.contains(thread)) {
        thread.join(PATIENCE_MS); // it is about to end
        left += thread.isAlive() ? 1 : 0;
      }
    }
    return left;
  }

  private static long descriptors() throws IOException {
    Path folder = Path.of("/proc/self/fd");
    if (!Files.isDirectory(folder)) {
      return 0;
    }
    try (Stream<Path> open = Files.list(folder)) {
      return open.count();
    }
  }
}
