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
 * Captures the log events of a class, instead of the console, until it is closed. A test that logs
 * a request to report an error must read the captured events before closing.
 */
public final class CapturedLog extends UnsynchronizedAppenderBase<ILoggingEvent>
    implements AutoCloseable {

  private final BlockingQueue<ILoggingEvent> events = new LinkedBlockingQueue<>();

  /** The captured events; after a close, some may still be on their way up to the root logger. */
  private static final Set<ILoggingEvent> TAKEN =
      Collections.synchronizedSet(Collections.newSetFromMap(new WeakHashMap<>()));

  private final Logger logger;
  private volatile boolean lookedAt;

  private CapturedLog(Logger logger) {
    this.logger = logger;
  }

  /** Starts to capture the events of a class. */
  public static CapturedLog of(Class<?> type) {
    CapturedLog log = new CapturedLog((Logger) LoggerFactory.getLogger(type));
    log.start();
    log.logger.addAppender(log);
    log.logger.setAdditive(false);
    return log;
  }

  /** Returns whether an event was captured. */
  static boolean took(ILoggingEvent event) {
    return TAKEN.contains(event);
  }

  /** Waits for the next message. */
  public String next() throws InterruptedException {
    return event().getFormattedMessage();
  }

  /** Waits for the next event. */
  public ILoggingEvent event() throws InterruptedException {
    lookedAt = true;
    ILoggingEvent event = events.poll(20, TimeUnit.SECONDS);
    if (event == null) {
      throw new AssertionError("nothing is logged");
    }
    return event;
  }

  /** Returns whether no event is waiting. */
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
