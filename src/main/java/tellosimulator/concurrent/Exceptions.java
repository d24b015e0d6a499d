package tellosimulator.concurrent;

/** Tells errors that concern one piece of work from those that concern the whole program. */
public final class Exceptions {

  private Exceptions() {}

  /**
   * Whether the Java machine itself is short of something, so that the next piece of work may fail
   * as well. A stack that overflowed is empty again as soon as it is caught.
   */
  public static boolean isFatal(Throwable failure) {
    return failure instanceof VirtualMachineError && !(failure instanceof StackOverflowError);
  }

  /** Throws a fatal error again; for those who catch everything else. */
  public static void throwIfFatal(Throwable failure) {
    if (isFatal(failure)) {
      throw (VirtualMachineError) failure;
    }
  }
}
