package tellosimulator.recording;

import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * Builds a row of {@code flight.csv}. Numbers are formatted by hand, because there may be a hundred
 * thousand rows a second. Not thread-safe.
 */
final class CsvRow {

  private static final long[] POWERS = {1, 10, 100, 1000};

  private final StringBuilder out = new StringBuilder(160);

  private StringBuilder next() {
    return out.isEmpty() ? out : out.append(',');
  }

  /** Appends cells that are already separated by commas. */
  CsvRow cells(String cells) {
    next().append(cells);
    return this;
  }

  /** Appends a text as a cell, in quotes if necessary (RFC 4180). */
  CsvRow text(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return cells(plain ? text : '"' + text.replace("\"", "\"\"") + '"');
  }

  /** Appends a position or a velocity in centimetres. */
  CsvRow vector(Vec3 meters, int decimals) {
    return number(Frames.centimeters(meters.x()), decimals)
        .number(Frames.centimeters(meters.y()), decimals)
        .number(Frames.centimeters(meters.z()), decimals);
  }

  /**
   * Appends a number, or an empty cell if the number is not finite.
   *
   * @param decimals the number of decimals, from 0 to 3
   */
  CsvRow number(double number, int decimals) {
    next();
    if (Double.isFinite(number)) {
      long scaled = Math.round(number * POWERS[decimals]);
      long size = Math.abs(scaled);
      out.append(scaled < 0 ? "-" : "").append(size / POWERS[decimals]);
      out.append(decimals > 0 ? "." : "");
      for (int digit = decimals - 1; digit >= 0; digit--) {
        out.append((char) ('0' + size / POWERS[digit] % 10));
      }
    }
    return this;
  }

  @Override
  public String toString() {
    return out.toString();
  }
}
