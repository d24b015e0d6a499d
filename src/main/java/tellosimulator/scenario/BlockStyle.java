package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import tellosimulator.scenario.SyntaxTree.Collection;
import tellosimulator.scenario.SyntaxTree.Element;
import tellosimulator.scenario.SyntaxTree.Syntax;

/** Writes values on lines of their own, in the style of others of a text. */
final class BlockStyle {

  /** How far something is indented below its key, or behind its dash, where nothing is like it. */
  private static final int INDENT = 2;

  private final TextEdits edits;

  /**
   * @param edits of the text
   */
  BlockStyle(TextEdits edits) {
    this.edits = edits;
  }

  /**
   * A list item with its dash.
   *
   * @param like whose style it has; empty for the usual one
   */
  List<String> item(Node item, Optional<Element> like) {
    int width = like.map(this::dashWidth).orElse(INDENT);
    List<String> lines = indented(width, value(item, like.map(Element::value)));
    lines.set(0, "-" + lines.get(0).substring(1));
    return lines;
  }

  /** How far an item is behind its dash. */
  private int dashWidth(Element item) {
    String before = edits.text().substring(edits.lineStart(item.start()), item.start());
    int dash = before.lastIndexOf('-');
    boolean near = dash >= 0 && before.substring(dash + 1).isBlank();
    return near ? before.length() - dash : INDENT;
  }

  private List<String> value(Node value, Optional<Syntax> like) {
    boolean block =
        like.filter(Collection.class::isInstance)
            .map(style -> !((Collection) style).flow())
            .orElse(value instanceof MappingNode map && map.getFlowStyle() == FlowStyle.BLOCK);
    List<String> lines = new ArrayList<>();
    if (block && value instanceof MappingNode mapping) {
      for (NodeTuple tuple : mapping.getValue()) {
        if (!Yaml.isUsual(tuple.getValueNode())) {
          lines.addAll(entry(tuple, like));
        }
      }
    }
    return lines.isEmpty() ? List.of(Yaml.inline(value)) : lines;
  }

  /**
   * A key with its value.
   *
   * @param parent in whose style it is; empty for the usual one
   */
  List<String> entry(NodeTuple tuple, Optional<Syntax> parent) {
    String key = ((ScalarNode) tuple.getKeyNode()).getValue() + ":";
    Node value = tuple.getValueNode();
    List<String> lines = new ArrayList<>();
    if (value instanceof SequenceNode list && list.getFlowStyle() == FlowStyle.BLOCK) {
      lines.add(key);
      lines.addAll(items(list));
      return lines;
    }
    Optional<Collection> like = value instanceof MappingNode ? inner(parent) : Optional.empty();
    if (like.isPresent()) {
      int indent = edits.column(like.get().start()) - edits.column(parent.orElseThrow().start());
      lines.add(key);
      lines.addAll(indented(Math.max(1, indent), value(value, Optional.of(like.get()))));
    } else {
      lines.add(key + " " + Yaml.inline(value));
    }
    return lines;
  }

  /** The items of a list, as they stand below its key. */
  List<String> items(SequenceNode list) {
    List<String> lines = new ArrayList<>();
    for (Node item : list.getValue()) {
      lines.addAll(indented(INDENT, item(item, Optional.empty())));
    }
    return lines;
  }

  /** A mapping on lines of its own within another one. */
  private static Optional<Collection> inner(Optional<Syntax> parent) {
    return parent
        .filter(Collection.class::isInstance)
        .flatMap(
            outer ->
                ((Collection) outer)
                    .elements().stream()
                        .map(Element::value)
                        .filter(BlockStyle::isBlockMapping)
                        .map(Collection.class::cast)
                        .findFirst());
  }

  /** Texts in several languages are no example: they are long, and other mappings are short. */
  private static boolean isBlockMapping(Syntax syntax) {
    return syntax instanceof Collection inner
        && !inner.flow()
        && inner.elements().stream().allMatch(element -> element.key().isPresent())
        && !inner.elements().stream()
            .allMatch(element -> element.key().filter(LocalizedTextCodec::isLanguage).isPresent());
  }

  private static List<String> indented(int width, List<String> lines) {
    List<String> indented = new ArrayList<>();
    for (String line : lines) {
      indented.add(line.isEmpty() ? line : " ".repeat(width) + line);
    }
    return indented;
  }
}
