package tellosimulator.concurrent;

/** What to do when memory is full. Made while there is memory. For any thread. */
final class MemoryAdvice {

  /** The least heap that is advised [MB]. Decided: everything but long recordings fits. */
  private static final long LEAST = 256;

  /** A command with twice the heap that this process has. */
  static final String COMMAND =
      "java -Xmx"
          + Math.max(LEAST, 2 * (Runtime.getRuntime().maxMemory() >> 20))
          + "m -jar tello-simulator.jar";

  private MemoryAdvice() {}
}
