package tellosimulator.comparison;

import java.util.Locale;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import tellosimulator.command.WireText;
import tellosimulator.comparison.FlownCommand.Motion;

/**
 * The columns of a comparison, in order. Each column shows one value of a command, for both
 * flights.
 */
public enum ComparisonColumn {
  REPLY((flown, locale) -> WireText.printable(flown.command().reply().stripTrailing())),
  /** The duration [s]. */
  SECONDS(
      (flown, locale) ->
          flown.command().duration().stream()
              .mapToObj(seconds -> String.format(locale, "%.2f", seconds))
              .collect(Collectors.joining())),
  /** Forward displacement [cm]. */
  FORWARD(whole(Motion::forward)),
  /** Displacement to the left [cm]. */
  LEFT(whole(Motion::left)),
  /** Upward displacement [cm]. */
  UP(whole(Motion::up)),
  /** Turn, clockwise [degrees]. */
  TURN(whole(Motion::turn));

  private final BiFunction<FlownCommand, Locale, String> text;

  ComparisonColumn(BiFunction<FlownCommand, Locale, String> text) {
    this.text = text;
  }

  /** Formats the value for users; empty if it is unknown. */
  public String text(FlownCommand flown, Locale locale) {
    return text.apply(flown, locale);
  }

  private static BiFunction<FlownCommand, Locale, String> whole(ToDoubleFunction<Motion> part) {
    return (flown, locale) ->
        flown
            .motion()
            .map(motion -> Long.toString(Math.round(part.applyAsDouble(motion))))
            .orElse("");
  }
}
