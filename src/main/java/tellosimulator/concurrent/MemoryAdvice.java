package tellosimulator.concurrent;

/** The advice to users when memory is exhausted. Created while memory is still available. */
final class MemoryAdvice {

  /**
   * Minimum heap size that the advice suggests [MB]. Decided: enough for everything except long
   * recordings.
   */
  private static final long LEAST = 256;

  /** A command that starts the program with twice the heap of this process. */
  static final String COMMAND =
      "java -Xmx"
          + Math.max(LEAST, 2 * (Runtime.getRuntime().maxMemory() >> 20))
          + "m -jar tello-simulator.jar";

  private MemoryAdvice() {}
}
