package tellosimulator.view.settings;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/**
 * Parses and formats the value of a setting. Immutable.
 *
 * @param allowed a description of the allowed values, worded to follow "must be"
 * @param read parses a text; returns empty if the value is not allowed
 * @param write formats a value
 */
public record SettingCodec<T>(
    String allowed, Function<String, Optional<T>> read, Function<T, String> write) {

  /** Returns the codec for a boolean. */
  public static SettingCodec<Boolean> flag() {
    return new SettingCodec<>(
        "true or false",
        text ->
            switch (text) {
              case "true" -> Optional.of(true);
              case "false" -> Optional.of(false);
              default -> Optional.empty();
            },
        value -> Boolean.toString(value));
  }

  /** Returns the codec for a number within limits, for properties of type double. */
  public static SettingCodec<Number> decimal(double least, double most) {
    return new SettingCodec<>(
        "from " + least + " to " + most,
        text ->
            number(text).filter(value -> value >= least && value <= most).map(Number.class::cast),
        value -> Double.toString(value.doubleValue()));
  }

  /** Returns the codec for an enum. Its constants are written in lower case. */
  public static <E extends Enum<E>> SettingCodec<E> constant(Class<E> type) {
    List<E> constants = Arrays.asList(type.getEnumConstants());
    Function<E, String> word = value -> value.name().toLowerCase(Locale.ROOT);
    return new SettingCodec<>(
        "one of " + String.join(", ", constants.stream().map(word).toList()),
        text -> constants.stream().filter(value -> word.apply(value).equals(text)).findFirst(),
        word);
  }

  private static Optional<Double> number(String text) {
    try {
      return Optional.of(Double.valueOf(text)).filter(Double::isFinite);
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }
}
