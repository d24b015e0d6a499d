package tellosimulator.cli;

import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/**
 * What was chosen for an option: on the command line, or else by default. For one thread.
 *
 * @param <T> what it means
 */
final class OptionValue<T> {

  private final OptionSpec option;
  private final T byDefault;

  /**
   * @param option whose values are read as {@code T}
   * @param byDefault what is chosen unless the option is given
   */
  OptionValue(OptionSpec option, T byDefault) {
    this.option = option;
    this.byDefault = byDefault;
  }

  T value() {
    return or(byDefault);
  }

  /** Whether the option stands on the command line. */
  boolean given() {
    CommandLine line = option.command().commandLine();
    return line.getParseResult() != null && line.getParseResult().hasMatchedOption(option);
  }

  /** What was chosen if the option is given, or else what somebody else says. */
  T or(T said) {
    return given() ? option.getValue() : said;
  }

  /** The option as one writes it. */
  String name() {
    return option.longestName();
  }
}
