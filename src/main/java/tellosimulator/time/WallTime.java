package tellosimulator.time;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
import java.util.OptionalLong;

/** A moment of the wall clock, for display and file names. No flight depends on it. Immutable. */
public final class WallTime {

  private static final DateTimeFormatter FOR_FILES =
      DateTimeFormatter.ofPattern("uuuu-MM-dd_HH-mm-ss", Locale.ROOT);

  private final OffsetDateTime moment;
  private final long nanos;

  private WallTime(OffsetDateTime moment, long nanos) {
    this.moment = moment;
    this.nanos = nanos;
  }

  /** Returns the current moment, in the machine's time zone. */
  public static WallTime now() {
    return new WallTime(OffsetDateTime.now(ZoneId.systemDefault()), System.nanoTime());
  }

  /** Returns the time of a clock that is never adjusted [ns]. Only differences are meaningful. */
  public static long nanoTime() {
    return System.nanoTime();
  }

  /**
   * Returns the time from this moment to another one [ms]; negative if the other one is earlier.
   *
   * @param when the other moment, on the clock of {@link #nanoTime}
   */
  public long millisUntil(long when) {
    return Math.floorDiv(when - nanos, 1_000_000L);
  }

  /** Formats the moment as ISO 8601, to the second, with the offset from UTC. */
  public String iso() {
    return DateTimeFormatter.ISO_OFFSET_DATE_TIME.format(moment.truncatedTo(ChronoUnit.SECONDS));
  }

  /**
   * Parses a moment in the format of {@link #iso}.
   *
   * @return microseconds since the start of 1970, UTC; empty if the text does not have this format
   */
  public static OptionalLong micros(String iso) {
    try {
      Instant moment = OffsetDateTime.parse(iso).toInstant();
      return OptionalLong.of(moment.getEpochSecond() * 1_000_000 + moment.getNano() / 1000);
    } catch (DateTimeException e) {
      return OptionalLong.empty();
    }
  }

  /** Formats the moment for a file name, to the second, so that names sort chronologically. */
  public String inFileName() {
    return FOR_FILES.format(moment);
  }
}
