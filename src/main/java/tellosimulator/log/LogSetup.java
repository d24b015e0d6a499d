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
 * Configures the log. The log is written to standard error through a queue, so that a slow console
 * never blocks the simulation. Logback finds this class as a service; compared with an XML file,
 * this saves a tenth of a second at each start. Messages of JavaFX are logged as well, because
 * SLF4J's implementation of {@code System.Logger} is on the class path.
 */
public final class LogSetup extends ContextAwareBase implements Configurator {

  /**
   * Maximum number of lines waiting for the console; when the queue is full, new lines are dropped.
   */
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

  /**
   * Sets the lowest level to be logged.
   *
   * @param level the name of the level, such as {@code debug}
   */
  public static void setLevel(String level) {
    LoggerContext context = (LoggerContext) LoggerFactory.getILoggerFactory();
    context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME).setLevel(Level.toLevel(level));
  }

  /** Writes all queued lines and stops the log. Nothing is logged afterwards. */
  public static void flush() {
    ((LoggerContext) LoggerFactory.getILoggerFactory()).stop();
  }

  /**
   * Writes to the console. If memory is exhausted, this class drops the line and reports the loss.
   * Without this class, the error would end the writer thread, and all subsequent lines would be
   * lost.
   */
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
   * Suppresses library messages that are irrelevant here: those below the warning level, and a
   * warning that JavaFX logs at each start from a class path. A single jar always starts JavaFX
   * from the class path.
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

  /**
   * The original standard error, even if the program redirects standard error later. Never closed.
   */
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
