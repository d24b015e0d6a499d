package tellosimulator.control;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.common.ScalarStyle;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.Event.ID;
import org.snakeyaml.engine.v2.events.MappingStartEvent;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.parser.Parser;
import org.snakeyaml.engine.v2.parser.ParserImpl;
import org.snakeyaml.engine.v2.scanner.StreamReader;
import tellosimulator.command.WireText;

/**
 * Reads flat JSON objects, and writes any. JSON is YAML 1.2, so the reader of scenario files reads
 * it; only its events are used, so that nothing nested is ever built.
 */
final class Json {

  /** Source: RFC 8259, section 6. */
  private static final Pattern NUMBER =
      Pattern.compile("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][-+]?[0-9]+)?");

  /** Fits a {@code long}. */
  private static final Pattern WHOLE = Pattern.compile("-?[0-9]{1,18}");

  private static final String EXPECTED =
      "expected a JSON object such as {\"id\": 1, \"token\": \"…\", \"do\": \"truth\"}";

  private Json() {}

  /**
   * The members of an object; texts are {@code String}, numbers {@code Long} or {@code Double},
   * true and false {@code Boolean}, and null is left out.
   *
   * @throws IllegalArgumentException with a sentence, if it is none or has a member that is an
   *     object or a list
   */
  static Map<String, Object> object(String text) {
    LoadSettings settings = LoadSettings.builder().setBufferSize(text.length() + 2).build();
    try {
      Parser parser = new ParserImpl(settings, new StreamReader(settings, text));
      Map<String, Object> members = new LinkedHashMap<>();
      expect(parser, ID.StreamStart);
      expect(parser, ID.DocumentStart);
      if (!(parser.next() instanceof MappingStartEvent start) || !start.isFlow()) {
        throw new IllegalArgumentException(EXPECTED);
      }
      for (Event next = parser.next(); next.getEventId() != ID.MappingEnd; next = parser.next()) {
        member(members, next, parser.next());
      }
      expect(parser, ID.DocumentEnd);
      expect(parser, ID.StreamEnd);
      return members;
    } catch (YamlEngineException e) {
      throw new IllegalArgumentException(EXPECTED, e);
    }
  }

  private static void expect(Parser parser, ID wanted) {
    if (parser.next().getEventId() != wanted) {
      throw new IllegalArgumentException(EXPECTED);
    }
  }

  private static void member(Map<String, Object> members, Event key, Event value) {
    if (!(key instanceof ScalarEvent name) || name.getScalarStyle() != ScalarStyle.DOUBLE_QUOTED) {
      throw new IllegalArgumentException(EXPECTED);
    }
    String shown = WireText.printable(name.getValue());
    if (members.containsKey(name.getValue())) {
      throw new IllegalArgumentException(shown + " is given twice");
    }
    if (!(value instanceof ScalarEvent scalar)) {
      throw new IllegalArgumentException(
          shown + " must be a text, a number, true or false, but is something nested");
    }
    if (scalar.getScalarStyle() == ScalarStyle.DOUBLE_QUOTED) {
      members.put(name.getValue(), scalar.getValue());
    } else if (!(scalar.isPlain() && scalar.getValue().equals("null"))) {
      members.put(name.getValue(), plain(scalar));
    }
  }

  private static Object plain(ScalarEvent scalar) {
    String word = scalar.getValue();
    if (!scalar.isPlain()) {
      throw new IllegalArgumentException(EXPECTED);
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
    throw new IllegalArgumentException(EXPECTED);
  }

  /**
   * A line of JSON, all in ASCII.
   *
   * @param value a map, a list, a text, a finite number, a {@code Boolean} or null
   */
  static String text(Object value) {
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

  private static void quote(StringBuilder out, String text) {
    out.append('"');
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"' || c == '\\') {
        out.append('\\').append(c);
      } else if (c < ' ' || c > '~') {
        out.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
      } else {
        out.append(c);
      }
    }
    out.append('"');
  }
}
