package tellosimulator.log;

import ch.qos.logback.classic.AsyncAppender;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.Configurator;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.OutputStreamAppender;
import ch.qos.logback.core.encoder.LayoutWrappingEncoder;
import ch.qos.logback.core.filter.Filter;
import ch.qos.logback.core.spi.ContextAwareBase;
import ch.qos.logback.core.spi.FilterReply;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.StandardError;

/**
 * Sets up the log: to standard error, through a queue, so that a slow console never makes the
 * simulation wait. Found by Logback as a service; without XML, which takes a tenth of a second.
 * What JavaFX logs arrives here too, because the class path holds SLF4J's service for the JDK's own
 * log.
 */
public final class LogSetup extends ContextAwareBase implements Configurator {

  /** Lines that may wait for the console; what comes on top is lost. */
  private static final int QUEUE = 8192;

  @Override
  public ExecutionStatus configure(LoggerContext context) {
    LogLayout line = new LogLayout();
    line.setContext(context);
    line.start();
    LayoutWrappingEncoder<ILoggingEvent> encoder = new LayoutWrappingEncoder<>();
    encoder.setContext(context);
    encoder.setLayout(line);
    encoder.start();

    OutputStreamAppender<ILoggingEvent> console = new Console();
    console.setContext(context);
    console.setOutputStream(new Terminal());
    console.setEncoder(encoder);
    console.addFilter(new Chatter());
    console.start();

    AsyncAppender queue = new AsyncAppender();
    queue.setContext(context);
    queue.setQueueSize(QUEUE);
    queue.setDiscardingThreshold(0);
    queue.setNeverBlock(true);
    queue.addAppender(console);
    queue.start();

    Logger root = context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    root.setLevel(Level.INFO);
    root.addAppender(queue);
    return ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY;
  }

  /** Lets lines of this level and above pass. */
  public static void setLevel(String level) {
    LoggerContext context = (LoggerContext) LoggerFactory.getILoggerFactory();
    context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME).setLevel(Level.toLevel(level));
  }

  /** Writes what is still waiting. */
  public static void flush() {
    ((LoggerContext) LoggerFactory.getILoggerFactory()).stop();
  }

  /** Loses a line rather than its thread, and with it all further lines, when memory is full. */
  private static final class Console extends OutputStreamAppender<ILoggingEvent> {

    private final StandardError standardError = new StandardError();
    private final byte[] lost =
        ("A line of the log is lost: memory is full" + System.lineSeparator())
            .getBytes(StandardCharsets.UTF_8);

    @Override
    protected void append(ILoggingEvent event) {
      try {
        super.append(event);
      } catch (OutOfMemoryError e) {
        standardError.write(lost);
      }
    }
  }

  /**
   * Keeps back what libraries say that is of use to nobody here: their chatter below warnings, and
   * what JavaFX says at each start from a class path, which is how one jar starts it.
   */
  private static final class Chatter extends Filter<ILoggingEvent> {
    @Override
    public FilterReply decide(ILoggingEvent event) {
      boolean own = event.getLoggerName().startsWith("tellosimulator");
      boolean worthReading =
          event.getLevel().isGreaterOrEqual(Level.WARN)
              && !event.getMessage().startsWith("Unsupported JavaFX configuration");
      return own || worthReading ? FilterReply.NEUTRAL : FilterReply.DENY;
    }
  }

  /** Standard error as it is now, whatever the program does to it later; never closed. */
  private static final class Terminal extends FilterOutputStream {
    Terminal() {
      super(System.err);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
      out.write(bytes, offset, length);
    }

    @Override
    public void close() throws IOException {
      flush();
    }
  }
}
