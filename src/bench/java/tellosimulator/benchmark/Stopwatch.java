package tellosimulator.benchmark;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/**
 * How long something takes on one core: processor time of this thread, so that other programs on
 * the machine matter less.
 */
final class Stopwatch {

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  private Stopwatch() {}

  /** Processor time [ms]. */
  static double ms(Runnable task) {
    long begun = THREADS.getCurrentThreadCpuTime();
    task.run();
    return (THREADS.getCurrentThreadCpuTime() - begun) * 1e-6;
  }
}
