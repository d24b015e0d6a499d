package tellosimulator.concurrent;

/** Work that is repeated on the thread of a {@link Worker}. */
public interface Agent {

  /** The outcome of a call to {@link #doWork}. */
  enum Outcome {
    /** Some work was done. The worker calls {@link Agent#doWork} again. */
    WORKED,
    /**
     * There was nothing to do. The worker calls {@link Agent#idle}, then {@link Agent#doWork}
     * again.
     */
    IDLE,
    /** There will be no more work. The thread ends. */
    FINISHED
  }

  /**
   * Does the work that is due. The call may block only if the code that ends the worker can unblock
   * it.
   */
  Outcome doWork() throws Exception;

  /** Waits until there may be work. */
  default void idle() throws Exception {}

  /**
   * Decides how the worker continues. Must return a policy that was allocated beforehand, since
   * memory may be exhausted.
   *
   * @param failure the exception or error that {@link #doWork} or {@link #idle} has thrown
   */
  ErrorPolicy onError(Throwable failure);

  /** Called last on the thread, no matter how the thread ends. */
  default void onClose() {}
}
