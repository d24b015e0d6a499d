package tellosimulator.concurrent;

/** Distinguishes errors in one piece of work from those that affect the whole program. */
public final class Exceptions {

  private Exceptions() {}

  /**
   * Returns whether a failure means that the JVM itself lacks resources, so that the next piece of
   * work may fail as well. A stack overflow does not count, because the stack is free again when
   * the error is caught.
   */
  public static boolean isFatal(Throwable failure) {
    return failure instanceof VirtualMachineError && !(failure instanceof StackOverflowError);
  }

  /** Rethrows a failure if it is fatal. Callers handle all other failures themselves. */
  public static void throwIfFatal(Throwable failure) {
    if (isFatal(failure)) {
      throw (VirtualMachineError) failure;
    }
  }
}
