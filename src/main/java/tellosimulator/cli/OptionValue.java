package tellosimulator.cli;

import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The value of an option: the value from the command line or, if there is none, the default. Not
 * thread-safe.
 *
 * @param <T> the type of the value
 */
final class OptionValue<T> {

  private final OptionSpec option;
  private final T byDefault;

  /**
   * Creates the value of an option.
   *
   * @param option an option whose values are parsed as {@code T}
   * @param byDefault the value if the option is not given
   */
  OptionValue(OptionSpec option, T byDefault) {
    this.option = option;
    this.byDefault = byDefault;
  }

  T value() {
    return or(byDefault);
  }

  /** Whether the option is given on the command line. */
  boolean given() {
    CommandLine line = option.command().commandLine();
    return line.getParseResult() != null && line.getParseResult().hasMatchedOption(option);
  }

  /** Returns the option's value if the option is given, otherwise {@code said}. */
  T or(T said) {
    return given() ? option.getValue() : said;
  }

  /** The option's name on the command line. */
  String name() {
    return option.longestName();
  }
}
