package tellosimulator;

import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.classic.spi.StackTraceElementProxy;
import ch.qos.logback.core.LayoutBase;
import tellosimulator.time.TimeOfDay;

/**
 * A line of the log: local time, level, message, and of an exception what it is and where it was
 * thrown. For the thread that writes the log. Not a pattern of Logback's: it would load a hundred
 * classes at each start for what a pattern may hold.
 */
final class LogLine extends LayoutBase<ILoggingEvent> {

  /** As wide as the longest level, ERROR. */
  private static final int LEVEL_WIDTH = 5;

  @Override
  public String doLayout(ILoggingEvent event) {
    StringBuilder line = new StringBuilder();
    TimeOfDay.append(line, event.getInstant());
    String level = event.getLevel().toString();
    line.append(' ')
        .append(level)
        .append(" ".repeat(Math.max(1, LEVEL_WIDTH + 1 - level.length())));
    line.append(event.getFormattedMessage()).append(System.lineSeparator());
    IThrowableProxy thrown = event.getThrowableProxy();
    if (thrown != null) {
      append(line, thrown);
    }
    return line.toString();
  }

  private static void append(StringBuilder line, IThrowableProxy thrown) {
    line.append(thrown.getClassName()).append(": ").append(thrown.getMessage());
    line.append(System.lineSeparator());
    StackTraceElementProxy[] trace = thrown.getStackTraceElementProxyArray();
    if (trace.length > 0) {
      line.append('\t').append(trace[0].getSTEAsString()).append(System.lineSeparator());
    }
  }
}
