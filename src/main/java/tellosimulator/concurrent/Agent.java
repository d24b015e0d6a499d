package tellosimulator.concurrent;

/** Work that is done again and again, on the thread of a {@link Worker}. */
public interface Agent {

  /** What a call of {@link #doWork} came to. */
  enum Outcome {
    /** It did something; call it again. */
    WORKED,
    /** There was nothing to do; call {@link #idle}, then it again. */
    IDLE,
    /** There never will be anything to do again; end the thread. */
    FINISHED
  }

  /**
   * Does what is to be done now. It may block, as long as whoever ends the worker can unblock it.
   */
  Outcome doWork() throws Exception;

  /** Waits until there may be something to do. */
  default void idle() throws Exception {}

  /**
   * Decides what becomes of the worker. Returns what was made beforehand: there may be no memory
   * left.
   *
   * @param failure what {@link #doWork} or {@link #idle} threw, errors included
   */
  ErrorPolicy onError(Throwable failure);

  /** The last thing that is done on the thread, whatever ended it. */
  default void onClose() {}
}
