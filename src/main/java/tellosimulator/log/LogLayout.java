package tellosimulator.log;

import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.classic.spi.StackTraceElementProxy;
import ch.qos.logback.core.LayoutBase;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import tellosimulator.words.Printable;

/**
 * Formats a line of the log: local time, level and message. For an exception, it adds the class,
 * the message and the place where it was thrown. Confined to the thread that writes the log.
 * Logback's {@code PatternLayout} is not used, since it would load a hundred classes at each start.
 */
final class LogLayout extends LayoutBase<ILoggingEvent> {

  /** Length of the name of the level ERROR, the longest name of a level [characters]. */
  private static final int LEVEL_WIDTH = 5;

  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("HH:mm:ss.SSS").withZone(ZoneId.systemDefault());

  @Override
  public String doLayout(ILoggingEvent event) {
    StringBuilder line = new StringBuilder();
    TIME.formatTo(event.getInstant(), line);
    String level = event.getLevel().toString();
    line.append(' ')
        .append(level)
        .append(" ".repeat(Math.max(1, LEVEL_WIDTH + 1 - level.length())));
    line.append(printable(event.getFormattedMessage())).append(System.lineSeparator());
    IThrowableProxy thrown = event.getThrowableProxy();
    if (thrown != null) {
      append(line, thrown);
    }
    return line.toString();
  }

  /**
   * Indents all lines but the first, so that text from untrusted sources cannot look like a log
   * message.
   */
  private static String printable(String text) {
    return Printable.of(text).replace("\n", System.lineSeparator() + "\t");
  }

  private static void append(StringBuilder line, IThrowableProxy thrown) {
    line.append(thrown.getClassName())
        .append(": ")
        .append(printable(String.valueOf(thrown.getMessage())));
    line.append(System.lineSeparator());
    StackTraceElementProxy[] trace = thrown.getStackTraceElementProxyArray();
    if (trace.length > 0) {
      line.append('\t').append(trace[0].getSTEAsString()).append(System.lineSeparator());
    }
  }
}
