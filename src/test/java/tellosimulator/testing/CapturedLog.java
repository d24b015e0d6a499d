package tellosimulator.testing;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.UnsynchronizedAppenderBase;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.slf4j.LoggerFactory;

/**
 * What a class logs, instead of the console, until it is closed. A test that lets people be asked
 * to report an error must look at what is logged before that.
 */
public final class CapturedLog extends UnsynchronizedAppenderBase<ILoggingEvent>
    implements AutoCloseable {

  private final BlockingQueue<ILoggingEvent> events = new LinkedBlockingQueue<>();

  /** What was captured; while one closes, its events may still be on their way up to the root. */
  private static final Set<ILoggingEvent> TAKEN =
      Collections.synchronizedSet(Collections.newSetFromMap(new WeakHashMap<>()));

  private final Logger logger;
  private volatile boolean lookedAt;

  private CapturedLog(Logger logger) {
    this.logger = logger;
  }

  /** Listens from now on. */
  public static CapturedLog of(Class<?> type) {
    CapturedLog log = new CapturedLog((Logger) LoggerFactory.getLogger(type));
    log.start();
    log.logger.addAppender(log);
    log.logger.setAdditive(false);
    return log;
  }

  /** Whether somebody captured an event. */
  static boolean took(ILoggingEvent event) {
    return TAKEN.contains(event);
  }

  /** Waits for the next sentence. */
  public String next() throws InterruptedException {
    return event().getFormattedMessage();
  }

  /** Waits for the next sentence with what belongs to it. */
  public ILoggingEvent event() throws InterruptedException {
    lookedAt = true;
    ILoggingEvent event = events.poll(20, TimeUnit.SECONDS);
    if (event == null) {
      throw new AssertionError("nothing is logged");
    }
    return event;
  }

  /** Whether there is none. */
  public boolean isEmpty() {
    lookedAt = true;
    return events.isEmpty();
  }

  @Override
  protected void append(ILoggingEvent event) {
    TAKEN.add(event);
    events.add(event);
  }

  @Override
  public void close() {
    logger.detachAppender(this);
    logger.setAdditive(true);
    stop();
    if (lookedAt) {
      return;
    }
    List<String> unseen =
        events.stream()
            .filter(UnexpectedErrors::asksForReport)
            .map(ILoggingEvent::getFormattedMessage)
            .toList();
    if (!unseen.isEmpty()) {
      throw new AssertionError("logged, and not looked at: " + unseen);
    }
  }
}
