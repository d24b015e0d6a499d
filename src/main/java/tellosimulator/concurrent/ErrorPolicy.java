package tellosimulator.concurrent;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The reaction of a worker to a failure of its agent: whether to continue, retry or finish, and
 * which message to log. A policy is allocated in advance, together with the message that is logged
 * if memory is exhausted. Thread-safe.
 */
public final class ErrorPolicy {

  private static final Logger LOG = LoggerFactory.getLogger(ErrorPolicy.class);

  private static final String FULL =
      "memory is full; give the program more, such as " + MemoryAdvice.COMMAND;

  /**
   * The standard error. It is created here, so that its class is loaded while memory is still
   * available.
   */
  private static final StandardError STANDARD_ERROR = new StandardError();

  enum Action {
    GO_ON,
    RETRY,
    FINISH
  }

  private final Action action;
  private final String what;
  private final byte[] withoutMemory;

  private ErrorPolicy(Action action, String what) {
    this.action = action;
    this.what = what;
    withoutMemory = (what + ": " + FULL + '\n').getBytes(StandardCharsets.UTF_8);
  }

  /**
   * Returns a policy with which the worker continues, no matter how often its agent fails.
   *
   * @param what the beginning of a sentence about the failure, such as "A picture could not be
   *     made"
   */
  public static ErrorPolicy goOn(String what) {
    return new ErrorPolicy(Action.GO_ON, what);
  }

  /**
   * Returns a policy with which the worker continues. The program ends if most of the worker's work
   * fails.
   *
   * @param what the beginning of a sentence about the failure
   */
  public static ErrorPolicy retry(String what) {
    return new ErrorPolicy(Action.RETRY, what);
  }

  /**
   * Returns a policy that ends the worker. The program continues without the worker.
   *
   * @param what the beginning of a sentence about the failure
   */
  public static ErrorPolicy finish(String what) {
    return new ErrorPolicy(Action.FINISH, what);
  }

  Action action() {
    return action;
  }

  /** Logs the failure and its reason in one sentence; never throws. */
  public void tell(Throwable failure) {
    tell(failure, 0);
  }

  /**
   * Logs the failure and its reason in one sentence; never throws.
   *
   * @param untold the number of failures of the same worker that have not been logged since the
   *     last message
   */
  void tell(Throwable failure, long untold) {
    try {
      String often =
          untold == 0 ? what : what + " (" + untold + " more times since the last message)";
      if (failure instanceof OutOfMemoryError) {
        LOG.error("{}: {}", often, FULL);
      } else if (failure instanceof IOException) {
        String why = failure.getMessage();
        LOG.warn("{}: {}", often, why == null ? "the system does not say why" : why);
      } else {
        LOG.error("{}; please report this: {}", often, failure.toString(), failure);
      }
    } catch (Throwable unsaid) { // most likely memory is exhausted
      STANDARD_ERROR.write(withoutMemory);
    }
  }
}
