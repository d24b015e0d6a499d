package tellosimulator.recording;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;

/**
 * The members of a JSON object of a recording. What is missing or of another type is empty, because
 * recordings of other versions are read as far as they go. Immutable; for any thread.
 */
record Fields(Map<?, ?> members) {

  /** The last moment of any simulation [s]. Decided: three years. */
  private static final double LATEST = 1e8;

  /**
   * The object that a text says.
   *
   * @throws IllegalArgumentException if it says none
   */
  static Fields of(String text) {
    return object(Json.value(text))
        .orElseThrow(() -> new IllegalArgumentException("expected a JSON object"));
  }

  private static Optional<Fields> object(Object value) {
    return value instanceof Map<?, ?> members ? Optional.of(new Fields(members)) : Optional.empty();
  }

  String text(String name) {
    return members.get(name) instanceof String text ? text : "";
  }

  OptionalDouble number(String name) {
    return members.get(name) instanceof Number number
        ? OptionalDouble.of(number.doubleValue())
        : OptionalDouble.empty();
  }

  /**
   * A moment of a simulation [s].
   *
   * @throws IllegalArgumentException if it is before its beginning, or later than any can be
   */
  OptionalDouble moment(String name) {
    OptionalDouble moment = number(name);
    if (moment.isPresent() && !isMoment(moment.getAsDouble())) {
      throw new IllegalArgumentException("there is no moment " + moment.getAsDouble());
    }
    return moment;
  }

  static boolean isMoment(double seconds) {
    return seconds >= 0 && seconds <= LATEST;
  }

  double numberOr(String name, double other) {
    return number(name).orElse(other);
  }

  OptionalInt whole(String name) {
    return members.get(name) instanceof Number number
        ? OptionalInt.of(number.intValue())
        : OptionalInt.empty();
  }

  Optional<Long> large(String name) {
    return members.get(name) instanceof Number number
        ? Optional.of(number.longValue())
        : Optional.empty();
  }

  Optional<Fields> object(String name) {
    return object(members.get(name));
  }

  /** The objects of an array. */
  List<Fields> objects(String name) {
    return members.get(name) instanceof List<?> items ? objects(items) : List.of();
  }

  static List<Fields> objects(List<?> items) {
    return items.stream().map(Fields::object).flatMap(Optional::stream).toList();
  }

  /** The texts of an array. */
  List<String> texts(String name) {
    return members.get(name) instanceof List<?> items
        ? items.stream().filter(String.class::isInstance).map(String.class::cast).toList()
        : List.of();
  }

  /** The place that x, y and z say in cm [m]; z is 0 if it is not said. */
  Optional<Vec3> place() {
    if (number("x").isEmpty() || number("y").isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new Vec3(
            Frames.meters(numberOr("x", 0)),
            Frames.meters(numberOr("y", 0)),
            Frames.meters(numberOr("z", 0))));
  }
}
