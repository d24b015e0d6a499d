package tellosimulator.json;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.common.ScalarStyle;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.Event.ID;
import org.snakeyaml.engine.v2.events.MappingStartEvent;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.events.SequenceStartEvent;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.parser.Parser;
import org.snakeyaml.engine.v2.parser.ParserImpl;
import org.snakeyaml.engine.v2.scanner.StreamReader;

/**
 * Parses and formats JSON. JSON is a subset of YAML 1.2, so the parser of scenario files parses it.
 * This class processes the parser's events itself, so that it stops parsing as soon as the input is
 * nested too deeply. Thread-safe.
 *
 * <p>Objects are represented by {@code Map}s in the order of their members, arrays by {@code
 * List}s, strings by {@code String}s, numbers by {@code Long}s or {@code Double}s, true and false
 * by {@code Boolean}s.
 */
public final class Json {

  /**
   * Maximum nesting depth of objects and arrays. Decided: no file of the project is more than four
   * levels deep.
   */
  private static final int DEEPEST = 32;

  /** The syntax of numbers. Source: RFC 8259, section 6. */
  private static final Pattern NUMBER =
      Pattern.compile("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][-+]?[0-9]+)?");

  /** A whole number of at most 18 digits, which always fits into a {@code long}. */
  private static final Pattern WHOLE = Pattern.compile("-?[0-9]{1,18}");

  private static final String HEX = "0123456789abcdef";

  private final Parser parser;
  private final String expected;
  private final int deepest;

  private Json(String text, String expected, int deepest) {
    LoadSettings settings = LoadSettings.builder().setBufferSize(text.length() + 2).build();
    this.parser = new ParserImpl(settings, new StreamReader(settings, text));
    this.expected = expected;
    this.deepest = deepest;
  }

  /**
   * Parses a JSON text. In arrays, null is kept; in objects, a member whose value is null is left
   * out.
   *
   * @throws IllegalArgumentException if the text is not JSON, or is nested too deeply; the message
   *     is one sentence
   */
  public static Object value(String text) {
    return read(text, "expected JSON", DEEPEST);
  }

  /**
   * Parses an object that contains no objects or arrays. Members whose value is null are left out.
   *
   * @param example an example of such an object, for the error message
   * @throws IllegalArgumentException if the text is not such an object; the message is one sentence
   */
  public static Map<String, Object> flatObject(String text, String example) {
    String expected = "expected a JSON object such as " + example;
    Map<String, Object> members = new LinkedHashMap<>();
    if (!(read(text, expected, 1) instanceof Map<?, ?> object)) {
      throw new IllegalArgumentException(expected);
    }
    object.forEach((name, value) -> members.put((String) name, value));
    return members;
  }

  private static Object read(String text, String expected, int deepest) {
    try {
      return new Json(text, expected, deepest).document();
    } catch (YamlEngineException e) {
      throw new IllegalArgumentException(expected, e);
    }
  }

  private Object document() {
    expect(ID.StreamStart);
    expect(ID.DocumentStart);
    Object value = value(parser.next(), "the text", 0);
    expect(ID.DocumentEnd);
    expect(ID.StreamEnd);
    return value;
  }

  private void expect(ID wanted) {
    if (parser.next().getEventId() != wanted) {
      throw new IllegalArgumentException(expected);
    }
  }

  /**
   * Returns the value that begins with the given event.
   *
   * @param name the name of the value, for error messages
   * @param depth the number of objects and arrays that contain the value
   */
  private Object value(Event event, String name, int depth) {
    if (event instanceof ScalarEvent scalar) {
      return scalar(scalar);
    }
    boolean object = event instanceof MappingStartEvent start && start.isFlow();
    boolean array = event instanceof SequenceStartEvent start && start.isFlow();
    if (depth >= deepest && depth > 0) {
      throw new IllegalArgumentException(
          deepest == 1
              ? name + " must be a text, a number, true or false, but is something nested"
              : name + " is nested deeper than " + deepest + " times");
    }
    if (object) {
      return object(depth + 1);
    }
    if (array) {
      return array(name, depth + 1);
    }
    throw new IllegalArgumentException(expected);
  }

  private Map<String, Object> object(int depth) {
    Map<String, Object> members = new LinkedHashMap<>();
    for (Event next = parser.next(); next.getEventId() != ID.MappingEnd; next = parser.next()) {
      if (!(next instanceof ScalarEvent name)
          || name.getScalarStyle() != ScalarStyle.DOUBLE_QUOTED) {
        throw new IllegalArgumentException(expected);
      }
      String shown = escaped(name.getValue());
      if (members.containsKey(name.getValue())) {
        throw new IllegalArgumentException(shown + " is given twice");
      }
      members.put(name.getValue(), value(parser.next(), shown, depth));
    }
    members.values().removeIf(value -> value == null);
    return members;
  }

  private List<Object> array(String name, int depth) {
    List<Object> items = new ArrayList<>();
    for (Event next = parser.next(); next.getEventId() != ID.SequenceEnd; next = parser.next()) {
      items.add(value(next, name, depth));
    }
    return Collections.unmodifiableList(items);
  }

  /** Returns the value of a scalar; null for null. */
  private Object scalar(ScalarEvent scalar) {
    String word = scalar.getValue();
    if (scalar.getScalarStyle() == ScalarStyle.DOUBLE_QUOTED) {
      return word;
    }
    if (!scalar.isPlain()) {
      throw new IllegalArgumentException(expected);
    }
    if (word.equals("null")) {
      return null;
    }
    if (word.equals("true") || word.equals("false")) {
      return word.equals("true");
    }
    if (WHOLE.matcher(word).matches() && NUMBER.matcher(word).matches()) {
      return Long.valueOf(word);
    }
    if (NUMBER.matcher(word).matches() && Double.isFinite(Double.parseDouble(word))) {
      return Double.valueOf(word);
    }
    throw new IllegalArgumentException(expected);
  }

  /**
   * Returns an object with the given members, in their order. Numbers of type {@code Double} are
   * {@link #rounded}. Optionals are replaced by their values; a member whose optional is empty is
   * left out.
   *
   * @param members names and values, alternating
   */
  public static Map<String, Object> object(Object... members) {
    Map<String, Object> object = new LinkedHashMap<>();
    for (int i = 0; i < members.length; i += 2) {
      Object value = content(members[i + 1]);
      if (value != null || members[i + 1] == null) {
        object.put((String) members[i], value instanceof Double number ? rounded(number) : value);
      }
    }
    return object;
  }

  /**
   * Returns the value of an optional, or null if it is empty; other values are returned unchanged.
   */
  static Object content(Object value) {
    if (value instanceof Optional<?> optional) {
      return optional.orElse(null);
    } else if (value instanceof OptionalInt optional) {
      return optional.isPresent() ? optional.getAsInt() : null;
    } else if (value instanceof OptionalDouble optional) {
      return optional.isPresent() ? optional.getAsDouble() : null;
    }
    return value;
  }

  /**
   * Formats a value as one line of JSON in ASCII.
   *
   * @param value a map, a list, a string, a finite number, a {@code Boolean} or null
   */
  public static String text(Object value) {
    StringBuilder out = new StringBuilder();
    write(out, value, "");
    return out.toString();
  }

  /**
   * Formats a value like {@link #text}, but with a line for each member and each item.
   *
   * @param value as for {@link #text}
   */
  public static String lines(Object value) {
    StringBuilder out = new StringBuilder();
    write(out, value, "\n");
    return out.toString();
  }

  /**
   * Writes a value.
   *
   * @param end the line break and indent before a closing bracket; empty for a single line
   */
  private static void write(StringBuilder out, Object value, String end) {
    String begin = end.isEmpty() ? "" : end + "  ";
    String next = end.isEmpty() ? ", " : "," + begin;
    if (value instanceof Map<?, ?> map) {
      String before = "{" + begin;
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        out.append(before);
        quote(out, String.valueOf(entry.getKey()));
        out.append(": ");
        write(out, entry.getValue(), begin);
        before = next;
      }
      out.append(map.isEmpty() ? "{}" : end + "}");
    } else if (value instanceof List<?> list) {
      String before = "[" + begin;
      for (Object item : list) {
        out.append(before);
        write(out, item, begin);
        before = next;
      }
      out.append(list.isEmpty() ? "[]" : end + "]");
    } else if (value instanceof String text) {
      quote(out, text);
    } else {
      out.append(value);
    }
  }

  private static void quote(StringBuilder out, String text) {
    out.append('"').append(escaped(text)).append('"');
  }

  /** Escapes quotes, backslashes and all characters other than printable ASCII. */
  private static String escaped(String text) {
    StringBuilder out = new StringBuilder();
    int written = 0;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c < ' ' || c > '~' || c == '"' || c == '\\') {
        out.append(text, written, i); // most texts need no escapes
        written = i + 1;
        escape(out, c);
      }
    }
    return out.append(text, written, text.length()).toString();
  }

  private static void escape(StringBuilder out, char c) {
    if (c == '"' || c == '\\') {
      out.append('\\').append(c);
      return;
    }
    out.append("\\u");
    for (int shift = 12; shift >= 0; shift -= 4) {
      out.append(HEX.charAt(c >> shift & 0xf));
    }
  }

  /**
   * Rounds a number to three decimals, the precision with which all times and lengths are written.
   */
  public static double rounded(double number) {
    return Math.round(number * 1000) / 1000.0;
  }
}
