package tellosimulator.control;

import java.time.Duration;
import java.util.Map;
import tellosimulator.command.WireText;

/**
 * The parameters of a request. Each method throws {@code IllegalArgumentException} with one
 * sentence as its message if a value is missing or of the wrong type. Immutable.
 *
 * @param of the name of the request
 */
record Parameters(String of, Map<String, Object> values) {

  /**
   * Maximum time by which a request may advance the simulation, or for which it may wait [s].
   * Decided: an hour.
   */
  private static final double LONGEST = 3600;

  Parameters {
    values = Map.copyOf(values);
  }

  String text(String name) {
    Object value = required(name, "a text");
    if (value instanceof String text) {
      return text;
    }
    throw wrong(name, "a text", value);
  }

  double number(String name) {
    return number(name, required(name, "a number"));
  }

  double number(String name, double otherwise) {
    return values.containsKey(name) ? number(name, values.get(name)) : otherwise;
  }

  boolean flag(String name) {
    Object value = required(name, "true or false");
    if (value instanceof Boolean flag) {
      return flag;
    }
    throw wrong(name, "true or false", value);
  }

  /** Returns the number of the drone; 1 if the request contains none. */
  int drone() {
    Object value = values.getOrDefault("drone", 1L);
    if (value instanceof Long number && number == number.intValue()) {
      return number.intValue();
    }
    throw wrong("drone", "a drone's number", value);
  }

  Duration seconds(String name) {
    return seconds(name, number(name));
  }

  Duration seconds(String name, double otherwise) {
    return seconds(name, Double.valueOf(number(name, otherwise)));
  }

  private Duration seconds(String name, Double value) {
    if (!(value >= 0 && value <= LONGEST)) {
      throw wrong(name, "from 0 to 3600 seconds", value);
    }
    return Duration.ofNanos(Math.round(value * 1e9));
  }

  private Object required(String name, String expected) {
    Object value = values.get(name);
    if (value == null) {
      throw new IllegalArgumentException(of + " needs " + name + ", " + expected);
    }
    return value;
  }

  private double number(String name, Object value) {
    if (value instanceof Number number) {
      return number.doubleValue();
    }
    throw wrong(name, "a number", value);
  }

  private IllegalArgumentException wrong(String name, String expected, Object value) {
    return new IllegalArgumentException(
        name + " of " + of + " must be " + expected + ", but is " + shown(value));
  }

  private static String shown(Object value) {
    return value instanceof String text
        ? "`" + WireText.printable(text) + "`"
        : String.valueOf(value);
  }
}
