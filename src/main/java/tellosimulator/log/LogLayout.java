package tellosimulator.log;

import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.classic.spi.StackTraceElementProxy;
import ch.qos.logback.core.LayoutBase;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import tellosimulator.words.Printable;

/**
 * Formats a line of the log: local time, level, message, and of an exception its class, its message
 * and where it was thrown. For the thread that writes the log. Logback's {@code PatternLayout}
 * would load a hundred classes at each start.
 */
final class LogLayout extends LayoutBase<ILoggingEvent> {

  /** As wide as the longest level, ERROR. */
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

  /** Lines after the first one are indented, so that no text from outside looks like a message. */
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
