package tellosimulator.time;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
import java.util.OptionalLong;

/**
 * A moment of the wall clock, for people and for names of files. No flight depends on one.
 * Immutable; for any thread.
 */
public final class WallTime {

  private static final DateTimeFormatter FOR_FILES =
      DateTimeFormatter.ofPattern("uuuu-MM-dd_HH-mm-ss", Locale.ROOT);

  private final OffsetDateTime moment;
  private final long nanos;

  private WallTime(OffsetDateTime moment, long nanos) {
    this.moment = moment;
    this.nanos = nanos;
  }

  /** This moment, in the machine's time zone. */
  public static WallTime now() {
    return new WallTime(OffsetDateTime.now(ZoneId.systemDefault()), System.nanoTime());
  }

  /** A clock that nobody puts right [ns]; only differences mean something. */
  public static long nanoTime() {
    return System.nanoTime();
  }

  /**
   * How long after this moment something was; negative if it was before [ms].
   *
   * @param when on the clock of {@link #nanoTime}
   */
  public long millisUntil(long when) {
    return Math.floorDiv(when - nanos, 1_000_000L);
  }

  /** As ISO 8601 has it, to the second, with the distance from UTC. */
  public String iso() {
    return DateTimeFormatter.ISO_OFFSET_DATE_TIME.format(moment.truncatedTo(ChronoUnit.SECONDS));
  }

  /**
   * What {@link #iso} said.
   *
   * @return microseconds since 1970, UTC; empty if the text is no such moment
   */
  public static OptionalLong micros(String iso) {
    try {
      Instant moment = OffsetDateTime.parse(iso).toInstant();
      return OptionalLong.of(moment.getEpochSecond() * 1_000_000 + moment.getNano() / 1000);
    } catch (DateTimeException e) {
      return OptionalLong.empty();
    }
  }

  /** In the name of a file, to the second; names are in the order of their moments. */
  public String inFileName() {
    return FOR_FILES.format(moment);
  }
}
