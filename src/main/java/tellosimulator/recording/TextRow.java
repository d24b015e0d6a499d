package tellosimulator.recording;

import tellosimulator.json.Json;
import tellosimulator.time.SimTime;

/**
 * Puts the lines of a file together without garbage: there may be a hundred thousand a second. For
 * one thread.
 */
final class TextRow {

  private static final long[] POWERS = {1, 10, 100, 1000};

  private final StringBuilder out = new StringBuilder();

  /** Adds a text as it is. */
  TextRow raw(String text) {
    out.append(text);
    return this;
  }

  TextRow raw(char c) {
    out.append(c);
    return this;
  }

  TextRow whole(long number) {
    out.append(number);
    return this;
  }

  /** Adds a text as JSON has it. */
  TextRow quoted(String text) {
    Json.quote(out, text);
    return this;
  }

  /** Adds a moment in seconds, to the millisecond. */
  TextRow seconds(SimTime time) {
    fixed(Math.floorDiv(time.nanos() + 500_000, 1_000_000L), 3);
    return this;
  }

  /**
   * Adds a number; nothing if it is not finite.
   *
   * @param decimals from 0 to 3
   */
  TextRow decimal(double number, int decimals) {
    if (Double.isFinite(number)) {
      fixed(Math.round(number * POWERS[decimals]), decimals);
    }
    return this;
  }

  private void fixed(long scaled, int decimals) {
    long size = Math.abs(scaled);
    if (scaled < 0) {
      out.append('-');
    }
    out.append(size / POWERS[decimals]);
    if (decimals > 0) {
      out.append('.');
    }
    for (int digit = decimals - 1; digit >= 0; digit--) {
      out.append((char) ('0' + size / POWERS[digit] % 10));
    }
  }

  /** Adds a text as a cell of a CSV file: in quotes if it needs them (RFC 4180). */
  TextRow cell(String text) {
    boolean plain = true;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      plain &= c != ',' && c != '"' && c != '\n' && c != '\r';
    }
    if (plain) {
      out.append(text);
    } else {
      out.append('"').append(text.replace("\"", "\"\"")).append('"');
    }
    return this;
  }

  /** Ends the line. */
  void end() {
    out.append('\n');
  }

  /** How much waits [characters]. */
  int length() {
    return out.length();
  }

  /** Takes all lines out. */
  String take() {
    String lines = out.toString();
    out.setLength(0);
    return lines;
  }
}
