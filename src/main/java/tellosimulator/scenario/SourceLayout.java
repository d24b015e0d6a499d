package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.nodes.CollectionNode;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.SequenceNode;

/**
 * The layout of a YAML text: the positions of its lists and mappings, of the elements in them, and
 * of the text between the elements. Offsets are in characters; ends are exclusive.
 *
 * <p>If no two elements share a line, the lines of an element include two kinds of comments:
 * comments directly above it, except for list items that were commented out, and comments below it
 * that are indented more deeply. Such comments are moved and removed together with the element.
 */
final class SourceLayout {

  /** The index of an element that is not in the text yet. */
  static final int NEW = -1;

  private static final String COMMENTED_ITEM = "#\\s*-\\s.*";

  /**
   * An element of a changed text.
   *
   * @param index the index of the element in the current text, or {@link #NEW}
   * @param text the new text of the element
   */
  record Piece(int index, String text) {}

  /** The range of a key with its value, or of a list item without its dash. */
  private record Span(int start, int end) {}

  /**
   * The range of the lines of an element, including its comments, but excluding the end of the last
   * line.
   */
  private record Lines(int top, Span span, int bottom) {}

  private final String text;

  /** The offset of each code point, since the marks of nodes count code points. */
  private final int[] offsets;

  /**
   * Creates the layout of a text.
   *
   * @param text a text in which each line ends with a line feed
   */
  SourceLayout(String text) {
    this.text = text;
    this.offsets =
        IntStream.rangeClosed(0, text.length())
            .filter(i -> i == text.length() || !Character.isLowSurrogate(text.charAt(i)))
            .toArray();
  }

  /** Returns the text from the start of one node to the end of another. */
  String text(Node first, Node last) {
    return text.substring(start(first), end(last));
  }

  private int start(Node node) {
    return offsets[node.getStartMark().orElseThrow().getIndex()];
  }

  /** Returns the end of a node. A list without brackets ends at the end of a line. */
  int end(Node node) {
    if (node instanceof MappingNode mapping && !isFlow(mapping)) {
      return end(mapping.getValue().get(mapping.getValue().size() - 1).getValueNode());
    }
    int end = withoutSpace(offsets[node.getEndMark().orElseThrow().getIndex()]);
    if (node instanceof SequenceNode list && !isFlow(list)) { // its end mark is after comments
      while (isComment(lineStart(end))) {
        end = withoutSpace(lineStart(end));
      }
      return lineEnd(end);
    }
    return end;
  }

  private int withoutSpace(int end) {
    int last = end;
    while (last > 0 && Character.isWhitespace(text.charAt(last - 1))) {
      last--;
    }
    return last;
  }

  static boolean isFlow(CollectionNode<?> collection) {
    return collection.getFlowStyle() == FlowStyle.FLOW;
  }

  private List<Span> spans(CollectionNode<?> collection) {
    List<Span> spans = new ArrayList<>();
    for (Object element : collection.getValue()) {
      Node first = element instanceof NodeTuple entry ? entry.getKeyNode() : (Node) element;
      Node last = element instanceof NodeTuple entry ? entry.getValueNode() : (Node) element;
      spans.add(new Span(start(first), end(last)));
    }
    return spans;
  }

  /**
   * Returns whether the elements follow each other in the text. This may not be so if there are
   * aliases, because these have the positions of the elements to which they refer.
   */
  boolean isInOrder(CollectionNode<?> collection) {
    int last = 0;
    for (Span span : spans(collection)) {
      if (span.start() < last || span.end() < span.start()) {
        return false;
      }
      last = span.end();
    }
    return true;
  }

  // --- replacing elements ---

  /**
   * Returns a part of the text after replacing the elements of a collection in it.
   *
   * @param pieces the new elements
   * @param collection a collection whose elements are in order
   * @param from the start of the part, before the first element
   * @param to the end of the part
   */
  String with(List<Piece> pieces, CollectionNode<?> collection, int from, int to) {
    List<Span> spans = spans(collection);
    boolean inBrackets = isFlow(collection) && !spans.stream().allMatch(this::hasOwnLines);
    return inBrackets || spans.isEmpty()
        ? inBrackets(pieces, collection, from, to)
        : onLines(pieces, collection, from, to);
  }

  /**
   * Writes the elements one after another. The existing separators are used as long as there are
   * enough of them.
   */
  private String inBrackets(List<Piece> pieces, CollectionNode<?> collection, int from, int to) {
    List<Span> spans = spans(collection);
    int count = spans.size();
    int tail = count == 0 ? end(collection) - 1 : spans.get(count - 1).end();
    StringBuilder changed = new StringBuilder();
    changed.append(text, from, count == 0 ? tail : spans.get(0).start());
    for (int i = 0; i < pieces.size(); i++) {
      if (i > 0) {
        changed.append(
            i < count ? text.substring(spans.get(i - 1).end(), spans.get(i).start()) : ", ");
      }
      changed.append(pieces.get(i).text());
    }
    String end = text.substring(tail, to);
    return changed.append(pieces.isEmpty() ? end.replaceFirst(",", "") : end).toString();
  }

  private String onLines(List<Piece> pieces, CollectionNode<?> collection, int from, int to) {
    boolean dashes = collection instanceof SequenceNode && !isFlow(collection);
    List<Lines> elements = new ArrayList<>();
    int indent = 0;
    int at = from;
    for (Span span : spans(collection)) {
      int line = lineStart(span.start());
      while (dashes && line > at && !text.startsWith("-", line + indent(line))) {
        line = lineStart(line - 1);
      }
      indent = indent(line);
      elements.add(new Lines(top(line, at), span, bottom(span.end(), indent, to)));
      at = elements.get(elements.size() - 1).bottom() + 1;
    }
    Map<Integer, String> gaps = gaps(pieces, elements);
    List<String> parts = new ArrayList<>();
    int first = elements.get(0).top();
    if (first > from) {
      parts.add(text.substring(from, first - 1));
    }
    int following = pieces.size();
    for (Piece piece : pieces) {
      following--;
      boolean comma = isFlow(collection) && following > 0;
      String written = piece.text() + (comma ? "," : "");
      if (piece.index() == NEW) {
        String lines = (dashes ? "- " : "") + written;
        parts.add(lines.replaceAll("(?m)^(?=.)", " ".repeat(indent)));
      } else {
        Lines old = elements.get(piece.index());
        Span span = old.span();
        boolean hasComma = text.startsWith(",", span.end());
        parts.add(
            gaps.get(piece.index())
                + text.substring(old.top(), span.start())
                + (hasComma ? piece.text() : written)
                + text.substring(span.end(), old.bottom()));
      }
    }
    String rest = gaps.get(NEW);
    if (!rest.isBlank()) {
      parts.add(rest.substring(0, rest.length() - 1));
    }
    int last = elements.get(elements.size() - 1).bottom();
    return String.join("\n", parts) + text.substring(last, to);
  }

  /**
   * Returns the lines that belong to no element, keyed by the index of the next remaining element;
   * the lines below the last remaining element have the key {@link #NEW}. Empty lines above and
   * below a removed element become one.
   */
  private Map<Integer, String> gaps(List<Piece> pieces, List<Lines> elements) {
    Map<Integer, String> gaps = new HashMap<>();
    var kept = pieces.stream().map(Piece::index).collect(Collectors.toSet());
    String gap = "";
    for (int i = 0; i < elements.size(); i++) {
      if (i > 0) {
        String more = text.substring(elements.get(i - 1).bottom() + 1, elements.get(i).top());
        gap = gap.isBlank() && more.startsWith("\n") ? more : gap + more;
      }
      if (kept.contains(i)) {
        gaps.put(i, gap);
        gap = "";
      }
    }
    gaps.put(NEW, gap);
    return gaps;
  }

  // --- lines ---

  private boolean hasOwnLines(Span span) {
    return span.start() == lineStart(span.start()) + indent(lineStart(span.start()))
        && text.substring(span.end(), lineEnd(span.end())).strip().matches(",?\\s*(#.*)?");
  }

  /**
   * Returns the start of the comments that belong to the element whose first line is given.
   * Comments at the top of the text belong to the whole file.
   */
  private int top(int line, int from) {
    int top = line;
    while (from > 0 && top > from) {
      int above = lineStart(top - 1);
      boolean its = isComment(above) && indent(above) == indent(line);
      if (!its || text.substring(above, top).strip().matches(COMMENTED_ITEM)) {
        break;
      }
      top = above;
    }
    return top;
  }

  private int bottom(int end, int indent, int to) {
    int bottom = lineEnd(end);
    while (bottom + 1 < to && isComment(bottom + 1) && indent(bottom + 1) > indent) {
      bottom = lineEnd(bottom + 1);
    }
    return Math.min(bottom, to);
  }

  private int lineStart(int at) {
    return text.lastIndexOf('\n', at - 1) + 1;
  }

  private int lineEnd(int at) {
    return text.indexOf('\n', at);
  }

  private int indent(int line) {
    int at = line;
    while (text.charAt(at) == ' ' || text.charAt(at) == '\t') {
      at++;
    }
    return at - line;
  }

  private boolean isComment(int line) {
    return text.startsWith("#", line + indent(line));
  }
}
