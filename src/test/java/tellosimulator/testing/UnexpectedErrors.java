package tellosimulator.testing;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.UnsynchronizedAppenderBase;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.slf4j.LoggerFactory;

/**
 * Fails a test during which the log contained a request to report an error, unless the test
 * captured it with a {@link CapturedLog}. JUnit registers it for each test automatically, as a
 * service.
 */
public final class UnexpectedErrors
    implements BeforeAllCallback, AfterEachCallback, AfterAllCallback, ParameterResolver {

  private static final Appender APPENDER = new Appender();

  /** Returns whether a log event asks the user to report an error. */
  static boolean asksForReport(ILoggingEvent event) {
    return event.getFormattedMessage().contains("please report");
  }

  @Override
  public void beforeAll(ExtensionContext context) {
    Logger root = (Logger) LoggerFactory.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    if (!root.isAttached(APPENDER)) {
      APPENDER.start();
      root.addAppender(APPENDER);
    }
  }

  @Override
  public void afterEach(ExtensionContext context) {
    check();
  }

  /** Checks the events of threads that outlived the last test. */
  @Override
  public void afterAll(ExtensionContext context) {
    check();
  }

  /** Fails if such an error has been logged since the last call. */
  void check() {
    List<String> errors = new ArrayList<>();
    for (String error = APPENDER.errors.poll(); error != null; error = APPENDER.errors.poll()) {
      errors.add(error);
    }
    if (!errors.isEmpty()) {
      throw new AssertionError("logged, and not expected with a CapturedLog: " + errors);
    }
  }

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
    return parameter.getParameter().getType() == UnexpectedErrors.class;
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
    return this;
  }

  /** An appender on the root logger: receives all events that no CapturedLog has captured. */
  private static final class Appender extends UnsynchronizedAppenderBase<ILoggingEvent> {

    private final Queue<String> errors = new ConcurrentLinkedQueue<>();

    @Override
    protected void append(ILoggingEvent event) {
      if (asksForReport(event) && !CapturedLog.took(event)) {
        errors.add(event.getThreadName() + ": " + event.getFormattedMessage());
      }
    }
  }
}
