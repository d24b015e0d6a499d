package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import tellosimulator.words.Phrase;
import tellosimulator.words.Spelling;

/** A mapping of a scenario file while it is read. */
final class Section {

  /** Something that was read, and where. */
  record Located<T>(T value, Node node) {}

  private final Kind kind;
  private final Node node;
  private final Mistakes mistakes;
  private final int mistakesBefore;
  private final Map<String, Node> values = new HashMap<>();

  private Section(Kind kind, Node node, Mistakes mistakes) {
    this.kind = kind;
    this.node = node;
    this.mistakes = mistakes;
    this.mistakesBefore = mistakes.count();
  }

  /** Looks at the keys; a node that is no mapping is one without keys. */
  static Section of(Kind kind, Node node, Mistakes mistakes) {
    Section section = new Section(kind, node, mistakes);
    if (node instanceof MappingNode mapping) {
      for (NodeTuple tuple : mapping.getValue()) {
        section.take(tuple);
      }
    } else {
      mistakes.add(node, Phrase.of("expected %s, found %s", kind.phrase(), Values.found(node)));
    }
    return section;
  }

  private void take(NodeTuple tuple) {
    Node key = tuple.getKeyNode();
    if (!(key instanceof ScalarNode scalar)) {
      mistakes.add(key, Phrase.of("expected a key, found %s", Values.found(key)));
      return;
    }
    String name = scalar.getValue();
    if (!kind.has(name)) {
      mistakes.add(Mistakes.place(key), () -> unknown(name));
    } else if (values.putIfAbsent(name, tuple.getValueNode()) != null) {
      mistakes.add(key, Phrase.of("the key %s is there twice", name));
    }
  }

  private Phrase unknown(String name) {
    String shown = Values.shown(name);
    return Spelling.meant(name, kind.keys())
        .map(meant -> Phrase.of("%s has no key %s, did you mean %s?", kind.phrase(), shown, meant))
        .orElseGet(
            () ->
                Phrase.of(
                    "%s has no key %s, but only %s",
                    kind.phrase(), shown, String.join(", ", kind.keys())));
  }

  Node node() {
    return node;
  }

  Mistakes mistakes() {
    return mistakes;
  }

  boolean has(String key) {
    return values.containsKey(key);
  }

  /** Where a value is, or else the section. */
  Node at(String key) {
    return values.getOrDefault(key, node);
  }

  /** Whether nothing was wrong in it so far. */
  boolean sound() {
    return mistakes.count() == mistakesBefore;
  }

  /** The key of a section that says by it what it is; a mistake if it has none, or several. */
  Optional<String> onlyKey() {
    if (values.size() == 1) {
      return Optional.of(values.keySet().iterator().next());
    }
    if (sound()) {
      mistakes.add(
          node,
          Phrase.of(
              "expected one of %s, found %d of them",
              String.join(", ", kind.keys()), values.size()));
    }
    return Optional.empty();
  }

  /** A value that can be there. */
  <T> Optional<T> read(String key, Value<T> value) {
    Node found = values.get(key);
    if (found == null) {
      check(key);
      return Optional.empty();
    }
    return value.read(found, mistakes);
  }

  /** A value that can be there, and what it is otherwise. */
  <T> T read(String key, Value<T> value, T otherwise) {
    return read(key, value).orElse(otherwise);
  }

  /** A value that must be there. */
  <T> Optional<T> need(String key, Value<T> value) {
    if (!has(key) && node instanceof MappingNode) {
      mistakes.add(node, Phrase.of("%s needs the key %s", kind.phrase(), key));
    }
    return read(key, value);
  }

  /** A value that must be there, and what stands for it until the mistake is told. */
  <T> T need(String key, Value<T> value, T meanwhile) {
    return need(key, value).orElse(meanwhile);
  }

  /** Keys that make no sense beside another. */
  void exclude(String key, String... others) {
    for (String other : others) {
      if (has(other)) {
        mistakes.add(at(other), Phrase.of("the key %s does not go with %s", other, key));
      }
    }
  }

  /** What a list holds that can be there. */
  <T> List<Located<T>> list(String key, int most, Value<T> item) {
    check(key);
    List<Located<T>> list = new ArrayList<>();
    for (Node element : elements(key, most)) {
      Optional<T> value = item.read(element, mistakes);
      if (value.isPresent()) {
        list.add(new Located<>(value.get(), element));
      }
    }
    return list;
  }

  private List<Node> elements(String key, int most) {
    Node found = values.get(key);
    if (found == null) {
      return List.of();
    }
    if (!(found instanceof SequenceNode sequence)) {
      mistakes.add(found, Phrase.of("expected a list, found %s", Values.found(found)));
      return List.of();
    }
    List<Node> elements = sequence.getValue();
    if (elements.size() > most) {
      mistakes.add(
          found, Phrase.of("expected a list of at most %d, found %d", most, elements.size()));
      return List.of();
    }
    return elements;
  }

  private void check(String key) {
    if (!kind.has(key)) {
      throw new IllegalArgumentException(kind + " has no key " + key);
    }
  }
}
