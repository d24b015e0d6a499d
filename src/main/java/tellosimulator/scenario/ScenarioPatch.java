package tellosimulator.scenario;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.snakeyaml.engine.v2.nodes.CollectionNode;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import tellosimulator.scenario.SourceLayout.Piece;

/**
 * The difference between two scenarios, which can be applied to the text of the first one. List
 * items and top-level entries that differ are written by the codecs; all others keep their text.
 *
 * @param before the node of the first scenario, including keys with default values
 * @param now the node of the other scenario, including keys with default values
 * @param obstacles the matches of the other scenario's obstacles, as returned by {@link #matches}
 */
record ScenarioPatch(Node before, Node now, List<Integer> obstacles) {

  /**
   * Returns whether two nodes have the same content, whatever their style and the order of keys.
   */
  static boolean same(Node a, Node b) {
    return content(a).equals(content(b));
  }

  private static Object content(Node node) {
    if (node instanceof MappingNode mapping) {
      Map<String, Object> entries = new HashMap<>();
      mapping.getValue().forEach(entry -> entries.put(key(entry), content(entry.getValueNode())));
      return entries;
    }
    return node instanceof SequenceNode list
        ? list.getValue().stream().map(ScenarioPatch::content).toList()
        : ((ScalarNode) node).getValue();
  }

  /**
   * Matches the items of a list with those of an earlier list. Equal items are matched first. Then,
   * each remaining item is matched with the item that follows the match of its predecessor, if that
   * item is still unmatched.
   *
   * @return for each item, its index in the earlier list or {@link SourceLayout#NEW}
   */
  static List<Integer> matches(List<?> before, List<?> now) {
    Map<Object, Deque<Integer>> unmatched = new HashMap<>();
    for (int i = 0; i < before.size(); i++) {
      unmatched.computeIfAbsent(before.get(i), item -> new ArrayDeque<>()).add(i);
    }
    List<Integer> matches = new ArrayList<>();
    for (Object item : now) {
      Deque<Integer> equal = unmatched.getOrDefault(item, new ArrayDeque<>());
      matches.add(equal.isEmpty() ? SourceLayout.NEW : equal.remove());
    }
    Set<Integer> used = new HashSet<>(matches);
    for (int i = 0; i < now.size(); i++) {
      int next = i == 0 ? 0 : matches.get(i - 1) + 1;
      if (matches.get(i) == SourceLayout.NEW && next < before.size() && used.add(next)) {
        matches.set(i, next);
      }
    }
    return matches;
  }

  /**
   * Returns the text of the other scenario; empty if the entries of the text cannot be located.
   * Callers must verify the result: it may describe a different scenario if the text contains
   * anchors or rare forms of YAML.
   *
   * @param text the text of the first scenario
   * @param byItem whether to write only the items of a list that differ, rather than all
   */
  Optional<String> applied(String text, boolean byItem) {
    if (same(before, now)) {
      return Optional.of(text);
    }
    boolean crlf = text.contains("\r\n") && !text.replace("\r\n", "").contains("\n");
    String suffix = text.endsWith("\n") ? "" : "\n";
    String lines = (crlf ? text.replace("\r\n", "\n") : text) + suffix;
    MappingNode root = (MappingNode) new Source("", new Diagnostics("")).root(lines).orElseThrow();
    SourceLayout layout = new SourceLayout(lines);
    if (!layout.isInOrder(root)) {
      return Optional.empty();
    }
    String changed = layout.with(entries(root, layout, byItem), root, 0, lines.length());
    String whole = changed.substring(0, changed.length() - suffix.length());
    return Optional.of(crlf ? whole.replace("\n", "\r\n") : whole);
  }

  /** Returns the entries of the other scenario, in the order of the text. */
  private List<Piece> entries(MappingNode root, SourceLayout layout, boolean byItem) {
    boolean flow = SourceLayout.isFlow(root);
    List<String> keys = new ArrayList<>();
    List<Piece> pieces = new ArrayList<>();
    for (int i = 0; i < root.getValue().size(); i++) {
      NodeTuple entry = root.getValue().get(i);
      String key = key(entry);
      Optional<Node> value = child(now, key);
      if (!differs(key)) {
        pieces.add(new Piece(i, layout.text(entry.getKeyNode(), entry.getValueNode())));
      } else if (byItem && hasItems(entry, layout)) {
        pieces.add(new Piece(i, list(entry, layout)));
      } else if (value.isPresent()) {
        pieces.add(new Piece(i, entry(key, value.get(), flow)));
      } else {
        continue; // removed
      }
      keys.add(key);
    }
    int slot = 0;
    for (NodeTuple entry : ((MappingNode) now).getValue()) {
      String key = key(entry);
      Node value = entry.getValueNode();
      if (keys.contains(key)) {
        slot = keys.indexOf(key) + 1;
      } else if (differs(key) && !Yaml.isUsual(value)) {
        boolean section = value instanceof CollectionNode<?> && !flow && slot > 0;
        String text = (section ? "\n" : "") + entry(key, value, flow);
        pieces.add(slot, new Piece(SourceLayout.NEW, text));
        keys.add(slot, key);
        slot++;
      }
    }
    return pieces;
  }

  private boolean differs(String key) {
    return !child(before, key)
        .map(ScenarioPatch::content)
        .equals(child(now, key).map(ScenarioPatch::content));
  }

  /**
   * Returns whether the items of a list can be located in the text. They cannot be located if they
   * are aliases, or if the text lists no drones and the scenario therefore has the default drone.
   */
  private boolean hasItems(NodeTuple entry, SourceLayout layout) {
    return entry.getValueNode() instanceof SequenceNode list
        && list.getValue().size() == items(before, key(entry)).size()
        && layout.isInOrder(list);
  }

  /** Returns the text of a key and its list, in which only the items that differ are changed. */
  private String list(NodeTuple entry, SourceLayout layout) {
    SequenceNode list = (SequenceNode) entry.getValueNode();
    boolean flow = SourceLayout.isFlow(list);
    String key = key(entry);
    List<Node> old = items(before, key);
    List<Node> items = items(now, key);
    List<Integer> matches =
        key.equals("obstacles") ? obstacles : matches(identities(old), identities(items));
    List<Piece> pieces = new ArrayList<>();
    for (int i = 0; i < items.size(); i++) {
      Node item = items.get(i);
      int match = matches.get(i);
      boolean unchanged = match != SourceLayout.NEW && same(old.get(match), item);
      Node place = unchanged ? list.getValue().get(match) : item;
      pieces.add(new Piece(match, unchanged ? layout.text(place, place) : item(item, flow)));
    }
    Node name = entry.getKeyNode();
    String changed = layout.with(pieces, list, layout.end(name), layout.end(list));
    boolean emptied = pieces.isEmpty() && !flow;
    return layout.text(name, name) + (emptied ? changed.replaceFirst(":", ": []") : changed);
  }

  private static List<Object> identities(List<Node> items) {
    return items.stream()
        .map(item -> item instanceof MappingNode ? child(item, "id").orElse(item) : item)
        .map(ScenarioPatch::content)
        .toList();
  }

  private static List<Node> items(Node scenario, String key) {
    return child(scenario, key).map(list -> ((SequenceNode) list).getValue()).orElse(List.of());
  }

  private static Optional<Node> child(Node mapping, String key) {
    return ((MappingNode) mapping)
        .getValue().stream()
            .filter(entry -> key(entry).equals(key))
            .map(NodeTuple::getValueNode)
            .findFirst();
  }

  private static String key(NodeTuple entry) {
    return ((ScalarNode) entry.getKeyNode()).getValue();
  }

  // --- written by the codecs ---

  /** Formats a whole file, with an empty line before each list and mapping except the first. */
  static String text(Node scenario) {
    StringBuilder text = new StringBuilder();
    for (NodeTuple entry : ((MappingNode) scenario).getValue()) {
      Node value = entry.getValueNode();
      if (!Yaml.isUsual(value)) {
        text.append(value instanceof CollectionNode<?> && !text.isEmpty() ? "\n" : "");
        text.append(entry(key(entry), value, false)).append("\n");
      }
    }
    return text.toString();
  }

  private static String entry(String key, Node value, boolean flow) {
    return !flow && value instanceof SequenceNode list && !list.getValue().isEmpty()
        ? list.getValue().stream()
            .map(item -> "\n  - " + item(item, false))
            .collect(Collectors.joining("", key + ":", ""))
        : key + ": " + Yaml.inline(value);
  }

  /**
   * Formats an item on one line. Outside brackets, the outer braces of an obstacle or goal are
   * omitted.
   */
  private static String item(Node item, boolean flow) {
    String line = Yaml.inline(item);
    boolean braces = flow || !(item instanceof MappingNode map) || SourceLayout.isFlow(map);
    return braces ? line : line.substring(1, line.length() - 1);
  }
}
