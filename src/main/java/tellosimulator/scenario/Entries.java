package tellosimulator.scenario;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.words.Phrase;

/** What was read of a mapping. */
final class Entries {

  private final Node node;
  private final Codec.Context context;
  private final int diagnosticsBefore;
  private final Map<String, Node> nodes = new HashMap<>();
  private final Map<String, Object> values = new HashMap<>();
  private final Set<String> unsound = new HashSet<>();

  Entries(Node node, Codec.Context context) {
    this.node = node;
    this.context = context;
    this.diagnosticsBefore = context.diagnostics().count();
  }

  /** Reads the value of a key. */
  <V> void read(Field<?, V> field, Phrase phrase) {
    int before = context.diagnostics().count();
    Node value = nodes.get(field.key());
    Optional<V> read = field.usual().map(Field.Usual::value);
    if (value != null) {
      read = field.codec().read(value, context);
    } else if (field.needed()) {
      need(field.key(), phrase);
    }
    if (read.isPresent()) {
      values.put(field.key(), read.get());
    }
    if (context.diagnostics().count() != before) {
      unsound.add(field.key());
    }
  }

  /** Tells that a key is missing. */
  void need(String key, Phrase phrase) {
    context.diagnostics().add(node, Phrase.of("%s needs the key %s", phrase, key));
  }

  /** Takes the node of a key; false if there is one already. */
  boolean put(String key, Node value) {
    return nodes.putIfAbsent(key, value) == null;
  }

  /** Whether nothing was wrong so far. */
  boolean sound() {
    return context.diagnostics().count() == diagnosticsBefore;
  }

  /** Whether nothing was wrong with the value of a key. */
  boolean sound(Field<?, ?> field) {
    return !unsound.contains(field.key());
  }

  /** Where the mapping is. */
  Node node() {
    return node;
  }

  /** The nodes of the keys that are there. */
  Map<String, Node> nodes() {
    return nodes;
  }

  Diagnostics diagnostics() {
    return context.diagnostics();
  }

  /** A value that is there, or its usual one; to be called for what is sound. */
  <V> V get(Field<?, V> field) {
    return find(field).orElseThrow();
  }

  /** The only value that is there. */
  Object only() {
    return values.values().iterator().next();
  }

  /** A value; empty if it is not there, or could not be read, and has no usual one. */
  @SuppressWarnings("unchecked") // the field put it there
  <V> Optional<V> find(Field<?, V> field) {
    return Optional.ofNullable((V) values.get(field.key()));
  }

  /** The same of a number. */
  OptionalInt findInt(Field<?, Integer> field) {
    Optional<Integer> found = find(field);
    return found.isPresent() ? OptionalInt.of(found.get()) : OptionalInt.empty();
  }

  /** Tells that a value is wrong that is there. */
  void diagnostic(Field<?, ?> field, Phrase phrase) {
    context.diagnostics().add(nodes.get(field.key()), phrase);
  }
}
