package tellosimulator.view.controls;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/** Parses and formats numbers in the window. */
final class NumberText {

  /** The typed form of numbers: a sign, digits, and decimals after a dot or a comma. */
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d{1,12}([.,]\\d{0,6})?|[.,]\\d{1,6})");

  private NumberText() {}

  /**
   * Parses a typed number, with a dot or a comma before its decimals.
   *
   * @return the number; empty for any other text, such as {@code 1e3}, {@code NaN} or {@code 12 m}
   */
  static OptionalDouble parse(String typed) {
    String text = typed.strip().replace('\u2212', '-');
    if (!NUMBER.matcher(text).matches()) {
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(Double.parseDouble(text.replace(',', '.')));
  }

  /** Formats a number without decimals, and never as "-0". */
  static String whole(double value) {
    return Long.toString(Math.round(value));
  }

  /** Formats a number for the locale, with one decimal if necessary. */
  static String of(double value, Locale locale) {
    DecimalFormat format = new DecimalFormat("0.#", DecimalFormatSymbols.getInstance(locale));
    double tenths = Math.round(value * 10) / 10.0;
    return format.format(tenths + 0.0); // turns -0 into 0
  }

  /** Formats the factor of simulated time, for example {@code 0.25 ×}. */
  static String factor(double value, Locale locale) {
    DecimalFormat format = new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(locale));
    return format.format(value) + " \u00d7";
  }

  /**
   * Formats a time as minutes, seconds and tenths, with hours if necessary, for example {@code
   * 2:05.3}.
   */
  static String time(double seconds) {
    long tenths = (long) Math.floor(seconds * 10 + 1e-6);
    long minutes = tenths / 600;
    if (minutes < 60) {
      return String.format(Locale.ROOT, "%d:%02d.%d", minutes, tenths / 10 % 60, tenths % 10);
    }
    return String.format(
        Locale.ROOT, "%d:%02d:%02d.%d", minutes / 60, minutes % 60, tenths / 10 % 60, tenths % 10);
  }

  /** Formats a count; values of ten thousand or more are shown in whole thousands. */
  static String count(long value) {
    return value < 10_000 ? Long.toString(value) : value / 1000 + " k";
  }
}
