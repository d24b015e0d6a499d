package tellosimulator.recording;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.json.Json;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;

/**
 * The members of a JSON object in a recording. Members that are missing or have another type are
 * read as empty, so that recordings of other versions can be read as far as possible. Immutable.
 */
record Fields(Map<?, ?> members) {

  /** The latest time that a recording may contain [s]. Decided: about three years. */
  private static final double LATEST = 1e8;

  /**
   * Parses a JSON object.
   *
   * @throws IllegalArgumentException if the text is not a JSON object
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

  /**
   * Returns a phrase.
   *
   * @param english name of the member that contains the same phrase in English, used if the phrase
   *     is missing or damaged
   */
  Phrase phrase(String name, String english) {
    return RecordedPhrase.of(members.get(name), text(english));
  }

  OptionalDouble number(String name) {
    return members.get(name) instanceof Number number
        ? OptionalDouble.of(number.doubleValue())
        : OptionalDouble.empty();
  }

  /**
   * Returns a simulated time [s].
   *
   * @throws IllegalArgumentException if it is negative, or later than the latest possible time
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

  /** Returns the objects of an array. */
  List<Fields> objects(String name) {
    return members.get(name) instanceof List<?> items ? objects(items) : List.of();
  }

  static List<Fields> objects(List<?> items) {
    return items.stream().map(Fields::object).flatMap(Optional::stream).toList();
  }

  /** Returns the strings of an array. */
  List<String> texts(String name) {
    return members.get(name) instanceof List<?> items
        ? items.stream().filter(String.class::isInstance).map(String.class::cast).toList()
        : List.of();
  }

  /**
   * Returns a position [m], converted from the members x, y and z in cm; empty if x or y is
   * missing. A missing z is 0.
   */
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
