package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.events.AliasEvent;
import org.snakeyaml.engine.v2.events.CollectionStartEvent;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.Event.ID;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.parser.Parser;
import org.snakeyaml.engine.v2.parser.ParserImpl;
import org.snakeyaml.engine.v2.scanner.StreamReader;

/**
 * Says where in a text each value is written, so that one can be changed without touching the rest.
 * Offsets are in characters; an end is behind the last one. For texts that have been read as a
 * scenario.
 */
final class SyntaxTree {

  /** A value. */
  sealed interface Syntax {

    int start();

    int end();

    /** The value of a key; empty for none, and of what is no mapping. */
    default Optional<Element> element(String key) {
      return Optional.empty();
    }
  }

  /**
   * A scalar, or an alias of something.
   *
   * @param value without quotation marks; empty for an alias
   */
  record Leaf(int start, int end, Optional<String> value) implements Syntax {}

  /**
   * A list or a mapping.
   *
   * @param flow whether it is in brackets or braces, rather than on lines of its own
   */
  record Collection(int start, int end, boolean flow, List<Element> elements) implements Syntax {

    @Override
    public Optional<Element> element(String key) {
      return elements.stream().filter(element -> element.key().equals(Optional.of(key))).findAny();
    }
  }

  /**
   * An item of a list, or a key with its value.
   *
   * @param key empty for an item
   * @param start where the key begins, or the item behind its dash
   * @param valueFrom behind the key, or where the item begins
   */
  record Element(Optional<String> key, int start, int valueFrom, Syntax value) {

    int end() {
      return Math.max(valueFrom, value.end());
    }
  }

  private final String text;
  private final Parser parser;

  /** Where each code point begins; empty if each is one character. */
  private final int[] offsets;

  private SyntaxTree(String text) {
    this.text = text;
    this.offsets = offsets(text);
    LoadSettings settings = LoadSettings.builder().setCodePointLimit(Integer.MAX_VALUE).build();
    this.parser = new ParserImpl(settings, new StreamReader(settings, text));
  }

  /** The only document of a text, which must have one. */
  static Syntax of(String text) {
    SyntaxTree tree = new SyntaxTree(text);
    tree.parser.next(); // the text starts
    tree.parser.next(); // the document starts
    return tree.value(tree.parser.next());
  }

  private Syntax value(Event event) {
    int start = offset(event.getStartMark());
    if (event instanceof ScalarEvent scalar) {
      int end = Math.max(start, withoutSpace(offset(event.getEndMark())));
      return new Leaf(start, end, Optional.of(scalar.getValue()));
    }
    if (event instanceof AliasEvent) {
      return new Leaf(start, offset(event.getEndMark()), Optional.empty());
    }
    boolean flow = ((CollectionStartEvent) event).getFlowStyle() == FlowStyle.FLOW;
    boolean mapping = event.getEventId() == ID.MappingStart;
    List<Element> elements = new ArrayList<>();
    Event next = parser.next();
    while (next.getEventId() != ID.MappingEnd && next.getEventId() != ID.SequenceEnd) {
      elements.add(mapping ? entry(value(next)) : item(value(next)));
      next = parser.next();
    }
    int end =
        flow || elements.isEmpty()
            ? offset(next.getEndMark())
            : elements.get(elements.size() - 1).end();
    return new Collection(start, end, flow, elements);
  }

  private static Element item(Syntax value) {
    return new Element(Optional.empty(), value.start(), value.start(), value);
  }

  private Element entry(Syntax key) {
    Optional<String> name = key instanceof Leaf leaf ? leaf.value() : Optional.empty();
    Syntax value = value(parser.next());
    int colon = text.indexOf(':', key.end());
    return new Element(name, key.start(), colon < 0 ? key.end() : colon + 1, value);
  }

  private static int[] offsets(String text) {
    int count = text.codePointCount(0, text.length());
    int[] offsets = new int[count == text.length() ? 0 : count + 1];
    for (int i = 1; i < offsets.length; i++) {
      offsets[i] = text.offsetByCodePoints(offsets[i - 1], 1);
    }
    return offsets;
  }

  /** Marks count code points. */
  private int offset(Optional<Mark> mark) {
    int index = mark.orElseThrow().getIndex();
    return offsets.length == 0 ? index : offsets[index];
  }

  /** The end of a block of text is behind the lines that follow it. */
  private int withoutSpace(int end) {
    int last = end;
    while (last > 0 && Character.isWhitespace(text.charAt(last - 1))) {
      last--;
    }
    return last;
  }
}
