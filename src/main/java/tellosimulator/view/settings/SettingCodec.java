package tellosimulator.view.settings;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/**
 * How a setting is written in the file, and which values it can have. Immutable.
 *
 * @param allowed which values, for people: a clause after "must be"
 * @param read the value of a text; empty if it is not allowed
 * @param write the text of a value
 */
public record SettingCodec<T>(
    String allowed, Function<String, Optional<T>> read, Function<T, String> write) {

  /** Yes or no. */
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

  /** A number within limits, for properties of type double. */
  public static SettingCodec<Number> decimal(double least, double most) {
    return new SettingCodec<>(
        "from " + least + " to " + most,
        text ->
            number(text).filter(value -> value >= least && value <= most).map(Number.class::cast),
        value -> Double.toString(value.doubleValue()));
  }

  /** A constant of an enum, in small letters. */
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
