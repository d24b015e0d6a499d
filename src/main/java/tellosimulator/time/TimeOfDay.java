package tellosimulator.time;

import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;

/** What a clock on the wall shows. For any thread. */
public final class TimeOfDay {

  private TimeOfDay() {}

  /**
   * Appends the local time of a moment: {@code 14:03:27.095}. Without a formatter of the JDK's,
   * whose loading takes longer than the start of a simulation.
   */
  public static void append(StringBuilder text, Instant moment) {
    LocalTime time = LocalTime.ofInstant(moment, ZoneId.systemDefault());
    append(text, time.getHour(), 2).append(':');
    append(text, time.getMinute(), 2).append(':');
    append(text, time.getSecond(), 2).append('.');
    append(text, time.getNano() / 1_000_000, 3);
  }

  private static StringBuilder append(StringBuilder text, int number, int digits) {
    String shown = Integer.toString(number);
    return text.append("0".repeat(digits - shown.length())).append(shown);
  }
}
