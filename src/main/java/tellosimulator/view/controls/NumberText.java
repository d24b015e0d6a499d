package tellosimulator.view.controls;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/** How numbers are typed and written in the window. */
final class NumberText {

  /** What people write: a sign, digits, and decimals after a dot or a comma. */
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d{1,12}([.,]\\d{0,6})?|[.,]\\d{1,6})");

  private NumberText() {}

  /**
   * The number that somebody typed, with a dot or a comma before its decimals.
   *
   * @return empty for everything else, also for exponents, {@code NaN} and {@code 12 m}
   */
  static OptionalDouble parse(String typed) {
    String text = typed.strip().replace('\u2212', '-');
    if (!NUMBER.matcher(text).matches()) {
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(Double.parseDouble(text.replace(',', '.')));
  }

  /** Without decimals, and never "-0". */
  static String whole(double value) {
    return Long.toString(Math.round(value));
  }

  /** With one decimal if it needs one, as people who speak the language write it. */
  static String of(double value, Locale locale) {
    DecimalFormat format = new DecimalFormat("0.#", DecimalFormatSymbols.getInstance(locale));
    double tenths = Math.round(value * 10) / 10.0;
    return format.format(tenths + 0.0); // makes 0 of -0
  }

  /** How many times as fast: {@code 0.25 ×}. */
  static String factor(double value, Locale locale) {
    DecimalFormat format = new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(locale));
    return format.format(value) + " \u00d7";
  }

  /** A time as minutes, seconds and tenths, with hours if there are any: {@code 2:05.3}. */
  static String time(double seconds) {
    long tenths = (long) Math.floor(seconds * 10 + 1e-6);
    long minutes = tenths / 600;
    if (minutes < 60) {
      return String.format(Locale.ROOT, "%d:%02d.%d", minutes, tenths / 10 % 60, tenths % 10);
    }
    return String.format(
        Locale.ROOT, "%d:%02d:%02d.%d", minutes / 60, minutes % 60, tenths / 10 % 60, tenths % 10);
  }

  /** A count that grows without end: in whole thousands from ten thousand on. */
  static String count(long value) {
    return value < 10_000 ? Long.toString(value) : value / 1000 + " k";
  }
}
