package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.snakeyaml.engine.v2.nodes.CollectionNode;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import tellosimulator.scenario.SyntaxTree.Collection;
import tellosimulator.scenario.SyntaxTree.Element;
import tellosimulator.scenario.SyntaxTree.Syntax;

/**
 * Makes the text of one scenario that of another, by changing only what differs. Both are compared
 * as the writer would write them, with all keys; a difference is carried over to where the text has
 * the value, or where it would have it.
 */
final class ScenarioPatch {

  private final TextEdits edits;
  private final BlockStyle style;
  private final Matching matching;

  /**
   * @param matching of the lists of both scenarios
   */
  ScenarioPatch(String text, Matching matching) {
    this.edits = new TextEdits(text);
    this.style = new BlockStyle(edits);
    this.matching = matching;
  }

  /**
   * The new text; empty if it cannot be made.
   *
   * @param before what the text says
   * @param now what it shall say
   * @param syntax of the text
   */
  Optional<String> applied(Node before, Node now, Syntax syntax) {
    value("", before, now, syntax);
    return edits.result();
  }

  /**
   * Changes sections as a whole.
   *
   * @param keys of the sections
   */
  Optional<String> rewritten(Set<String> keys, Node now, Collection root) {
    for (String key : keys) {
      Optional<Node> value = child(now, key);
      Optional<Element> element = root.element(key);
      if (value.isPresent() && element.isPresent()) {
        whole(element.get(), value.get());
      }
    }
    return edits.result();
  }

  /** Whether two nodes say the same. */
  static boolean same(Node a, Node b) {
    if (a instanceof ScalarNode one && b instanceof ScalarNode other) {
      return one.getValue().equals(other.getValue());
    }
    if (a instanceof SequenceNode one && b instanceof SequenceNode other) {
      List<Node> others = other.getValue();
      return one.getValue().size() == others.size()
          && IntStream.range(0, others.size())
              .allMatch(i -> same(one.getValue().get(i), others.get(i)));
    }
    return a instanceof MappingNode one && b instanceof MappingNode && differing(one, b).isEmpty();
  }

  /** The keys of two mappings whose values differ. */
  static Set<String> differing(Node a, Node b) {
    Set<String> keys = new HashSet<>(keys(a));
    keys.addAll(keys(b));
    keys.removeIf(
        key -> {
          Optional<Node> one = child(a, key);
          Optional<Node> other = child(b, key);
          return one.isPresent() && other.isPresent() && same(one.get(), other.get());
        });
    return keys;
  }

  private static List<String> keys(Node mapping) {
    return ((MappingNode) mapping).getValue().stream().map(ScenarioPatch::key).toList();
  }

  private static String key(NodeTuple tuple) {
    return ((ScalarNode) tuple.getKeyNode()).getValue();
  }

  private static Optional<Node> child(Node mapping, String key) {
    return ((MappingNode) mapping)
        .getValue().stream()
            .filter(tuple -> key(tuple).equals(key))
            .map(NodeTuple::getValueNode)
            .findFirst();
  }

  /**
   * Changes a value.
   *
   * @param key under which it is; empty for none
   */
  private void value(String key, Node before, Node now, Syntax syntax) {
    if (same(before, now)) {
      return;
    }
    if (syntax instanceof Collection written && fits(before, now, written)) {
      if (now instanceof MappingNode) {
        mapping(before, now, written);
      } else if (numbers(now)) {
        numbers((SequenceNode) before, (SequenceNode) now, written);
      } else {
        list(key, (SequenceNode) before, (SequenceNode) now, written);
      }
    } else {
      edits.replace(syntax.start(), syntax.end(), Yaml.inline(now));
    }
  }

  /** Whether what is written has the same parts as both nodes, or some of them. */
  private static boolean fits(Node before, Node now, Collection written) {
    int size = written.elements().size();
    if (before instanceof SequenceNode was && now instanceof SequenceNode is) {
      boolean sameNumber = was.getValue().size() == is.getValue().size();
      return was.getValue().size() == size && (sameNumber || !numbers(now));
    }
    return before instanceof MappingNode
        && now instanceof MappingNode
        && (size == 0
            || written.elements().stream()
                .anyMatch(element -> element.key().filter(keys(now)::contains).isPresent()));
  }

  private static boolean numbers(Node list) {
    return list instanceof SequenceNode sequence
        && !sequence.getValue().isEmpty()
        && sequence.getValue().get(0) instanceof ScalarNode;
  }

  private void numbers(SequenceNode before, SequenceNode now, Collection written) {
    for (int i = 0; i < written.elements().size(); i++) {
      value("", before.getValue().get(i), now.getValue().get(i), written.elements().get(i).value());
    }
  }

  private void mapping(Node before, Node now, Collection written) {
    ElementEdits elements = new ElementEdits(edits, written);
    List<Element> present = written.elements();
    for (int i = 0; i < present.size(); i++) {
      String key = present.get(i).key().orElse("");
      if (child(now, key).isEmpty() && child(before, key).isPresent()) {
        elements.remove(i);
      }
    }
    int slot = 0;
    for (NodeTuple tuple : ((MappingNode) now).getValue()) {
      Optional<Element> element = written.element(key(tuple));
      Optional<Node> was = child(before, key(tuple));
      Node value = tuple.getValueNode();
      if (element.isPresent()) {
        slot = present.indexOf(element.get()) + 1;
        entry(element.get(), was, value);
      } else if (!Yaml.isUsual(value) && was.filter(node -> same(node, value)).isEmpty()) {
        List<String> lines = new ArrayList<>(style.entry(tuple, Optional.of(written)));
        if (value instanceof CollectionNode<?> && !numbers(value)) {
          lines.add(0, ""); // as before each section
        }
        elements.add(slot, List.of(key(tuple) + ": " + Yaml.inline(value)), lines);
      }
    }
  }

  private void entry(Element element, Optional<Node> before, Node now) {
    if (before.isPresent() && same(before.get(), now)) {
      return;
    }
    boolean emptied = now instanceof SequenceNode list && list.getValue().isEmpty();
    if (emptied && element.value() instanceof Collection block && !block.flow()) {
      edits.insert(element.valueFrom(), " []");
    }
    value(element.key().orElse(""), before.orElse(now), now, element.value());
  }

  private void list(String key, SequenceNode before, SequenceNode now, Collection written) {
    ElementEdits elements = new ElementEdits(edits, written);
    List<Integer> matches = matching.of(key);
    for (int i = 0; i < written.elements().size(); i++) {
      if (!matches.contains(i)) {
        elements.remove(i);
      }
    }
    int slot = 0;
    List<Node> added = new ArrayList<>();
    for (int i = 0; i < matches.size(); i++) {
      int match = matches.get(i);
      if (match == Matching.NEW) {
        added.add(now.getValue().get(i));
      } else {
        add(elements, slot, added, written);
        added.clear();
        Syntax item = written.elements().get(match).value();
        value("", before.getValue().get(match), now.getValue().get(i), item);
        slot = match + 1;
      }
    }
    add(elements, written.elements().size(), added, written);
  }

  /** Adds items in the style of the one before. */
  private void add(ElementEdits elements, int slot, List<Node> added, Collection written) {
    if (added.isEmpty()) {
      return;
    }
    Optional<Element> like =
        written.elements().isEmpty()
            ? Optional.empty()
            : Optional.of(written.elements().get(Math.max(0, slot - 1)));
    List<String> lines = new ArrayList<>();
    for (Node item : added) {
      lines.addAll(style.item(item, like));
    }
    elements.add(slot, added.stream().map(Yaml::inline).toList(), lines);
  }

  private void whole(Element element, Node value) {
    List<String> lines = new ArrayList<>();
    if (value instanceof SequenceNode list && !list.getValue().isEmpty()) {
      lines.add("");
      lines.addAll(style.items(list));
    } else {
      lines.add(" " + Yaml.inline(value));
    }
    edits.replace(element.valueFrom(), element.end(), lines);
  }
}
