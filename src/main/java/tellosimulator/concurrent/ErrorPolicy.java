package tellosimulator.concurrent;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * How a worker reacts when its agent throws: continue, retry or finish; and the message to log.
 * Allocated in advance, with a message for the case that memory is exhausted. For any thread.
 */
public final class ErrorPolicy {

  private static final Logger LOG = LoggerFactory.getLogger(ErrorPolicy.class);

  private static final String FULL =
      "memory is full; give the program more, such as " + MemoryAdvice.COMMAND;

  /** Made, and with it its class loaded, while there is memory. */
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
   * It goes on, however often this happens.
   *
   * @param what failed: the beginning of a sentence, such as "A picture could not be made"
   */
  public static ErrorPolicy goOn(String what) {
    return new ErrorPolicy(Action.GO_ON, what);
  }

  /** It goes on, but ends the program when most of its work fails. */
  public static ErrorPolicy retry(String what) {
    return new ErrorPolicy(Action.RETRY, what);
  }

  /** It ends; the program does not need it. */
  public static ErrorPolicy finish(String what) {
    return new ErrorPolicy(Action.FINISH, what);
  }

  Action action() {
    return action;
  }

  /** Says in one sentence what failed, and why; never throws. */
  public void tell(Throwable failure) {
    tell(failure, 0);
  }

  /**
   * Says in one sentence what failed, and why; never throws.
   *
   * @param untold how often the same worker failed without a word since its last sentence
   */
  void tell(Throwable failure, long untold) {
    try {
      String often = untold == 0 ? what : what + " (" + untold + " times more since it was told)";
      if (failure instanceof OutOfMemoryError) {
        LOG.error("{}: {}", often, FULL);
      } else if (failure instanceof IOException) {
        String why = failure.getMessage();
        LOG.warn("{}: {}", often, why == null ? "the system does not say why" : why);
      } else {
        LOG.error("{}; please report this: {}", often, failure.toString(), failure);
      }
    } catch (Throwable unsaid) { // most likely there is no memory for it
      STANDARD_ERROR.write(withoutMemory);
    }
  }
}
