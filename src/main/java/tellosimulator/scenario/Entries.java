package tellosimulator.scenario;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.words.Phrase;

/** The entries of a mapping that have been read so far. */
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

  /** Reads the value of a key, or uses its default. Reports a missing required key. */
  <V> void read(Field<?, V> field, Phrase phrase) {
    int before = context.diagnostics().count();
    Node value = nodes.get(field.key());
    Optional<V> read = field.usual().map(Field.Default::value);
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

  /** Reports a missing key. */
  void need(String key, Phrase phrase) {
    context.diagnostics().add(node, Phrase.of("%s needs the key %s", phrase, key));
  }

  /** Stores the node of a key; returns false if the key already has one. */
  boolean put(String key, Node value) {
    return nodes.putIfAbsent(key, value) == null;
  }

  /** Returns whether everything that has been read so far is valid. */
  boolean sound() {
    return context.diagnostics().count() == diagnosticsBefore;
  }

  /** Returns whether the value of a key was read without errors. */
  boolean sound(Field<?, ?> field) {
    return !unsound.contains(field.key());
  }

  /** The node of the mapping. */
  Node node() {
    return node;
  }

  /** The nodes of all present keys. */
  Map<String, Node> nodes() {
    return nodes;
  }

  Diagnostics diagnostics() {
    return context.diagnostics();
  }

  /**
   * Returns a value, or its default if the key is missing. Must be called only if one of them
   * exists.
   */
  <V> V get(Field<?, V> field) {
    return find(field).orElseThrow();
  }

  /** Returns the only value of a mapping that has exactly one. */
  Object only() {
    return values.values().iterator().next();
  }

  /**
   * Returns a value, or its default if the key is missing. Returns empty if the value could not be
   * read, or if the key is missing and has no default.
   */
  @SuppressWarnings("unchecked") // stored by the field itself
  <V> Optional<V> find(Field<?, V> field) {
    return Optional.ofNullable((V) values.get(field.key()));
  }

  /** Returns a number; empty in the same cases as {@link #find}. */
  OptionalInt findInt(Field<?, Integer> field) {
    Optional<Integer> found = find(field);
    return found.isPresent() ? OptionalInt.of(found.get()) : OptionalInt.empty();
  }

  /** Reports an error in the value of a key that is present. */
  void diagnostic(Field<?, ?> field, Phrase phrase) {
    context.diagnostics().add(nodes.get(field.key()), phrase);
  }

  /** Reports that the value of a key that is present does not fit another value. */
  void misfit(Field<?, ?> field, Phrase phrase) {
    context.diagnostics().misfit(Diagnostics.place(nodes.get(field.key())), phrase);
  }
}
