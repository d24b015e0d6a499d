package tellosimulator.json;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
 * Reads and writes JSON. JSON is YAML 1.2, so the reader of scenario files reads it; only its
 * events are used, so that nothing is built that is nested too deep. For any thread.
 *
 * <p>Objects are {@code Map}s in the order of their members, arrays {@code List}s, texts {@code
 * String}, numbers {@code Long} or {@code Double}, true and false {@code Boolean}.
 */
public final class Json {

  /** How deep objects and arrays may be nested. Decided: no file of the project needs five. */
  private static final int DEEPEST = 32;

  /** Source: RFC 8259, section 6. */
  private static final Pattern NUMBER =
      Pattern.compile("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][-+]?[0-9]+)?");

  /** Fits a {@code long}. */
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
   * What a text says; null is kept in arrays, and a member that is null is left out.
   *
   * @throws IllegalArgumentException with a sentence, if the text is no JSON or nested too deep
   */
  public static Object value(String text) {
    return read(text, "expected JSON", DEEPEST);
  }

  /**
   * The members of an object that has no object and no array in it; those that are null are left
   * out.
   *
   * @param example of such an object, for the sentence that refuses something else
   * @throws IllegalArgumentException with a sentence, if it is none or has something nested
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
   * @param name of what is read, for a sentence
   * @param depth in how many objects and arrays it is
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

  /** Null for null. */
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
   * A line of JSON, all in ASCII.
   *
   * @param value a map, a list, a text, a finite number, a {@code Boolean} or null
   */
  public static String text(Object value) {
    StringBuilder out = new StringBuilder();
    write(out, value);
    return out.toString();
  }

  private static void write(StringBuilder out, Object value) {
    if (value instanceof Map<?, ?> map) {
      String before = "{";
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        out.append(before);
        quote(out, String.valueOf(entry.getKey()));
        out.append(": ");
        write(out, entry.getValue());
        before = ", ";
      }
      out.append(map.isEmpty() ? "{}" : "}");
    } else if (value instanceof List<?> list) {
      String before = "[";
      for (Object item : list) {
        out.append(before);
        write(out, item);
        before = ", ";
      }
      out.append(list.isEmpty() ? "[]" : "]");
    } else if (value instanceof String text) {
      quote(out, text);
    } else {
      out.append(value);
    }
  }

  /** Adds a text in quotes, all in ASCII. */
  public static void quote(StringBuilder out, String text) {
    out.append('"');
    escape(out, text);
    out.append('"');
  }

  private static String escaped(String text) {
    StringBuilder out = new StringBuilder();
    escape(out, text);
    return out.toString();
  }

  private static void escape(StringBuilder out, String text) {
    int written = 0;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c < ' ' || c > '~' || c == '"' || c == '\\') {
        out.append(text, written, i); // most texts are plain
        written = i + 1;
        escape(out, c);
      }
    }
    out.append(text, written, text.length());
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

  /** A number to three decimals, as all times and lengths are written. */
  public static double rounded(double number) {
    return Math.round(number * 1000) / 1000.0;
  }
}
