package tellosimulator.testing;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.UnsynchronizedAppenderBase;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.slf4j.LoggerFactory;

/** What a class logs, instead of the console, until it is closed. */
public final class CapturedLog extends UnsynchronizedAppenderBase<ILoggingEvent>
    implements AutoCloseable {

  private final BlockingQueue<ILoggingEvent> events = new LinkedBlockingQueue<>();
  private final Logger logger;

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

  /** Waits for the next sentence. */
  public String next() throws InterruptedException {
    return event().getFormattedMessage();
  }

  /** Waits for the next sentence with what belongs to it. */
  public ILoggingEvent event() throws InterruptedException {
    ILoggingEvent event = events.poll(20, TimeUnit.SECONDS);
    if (event == null) {
      throw new AssertionError("nothing is logged");
    }
    return event;
  }

  /** Whether there is none. */
  public boolean isEmpty() {
    return events.isEmpty();
  }

  @Override
  protected void append(ILoggingEvent event) {
    events.add(event);
  }

  @Override
  public void close() {
    logger.setAdditive(true);
    logger.detachAppender(this);
    stop();
  }
}
