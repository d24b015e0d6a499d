package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import tellosimulator.words.Phrase;
import tellosimulator.words.Printable;
import tellosimulator.words.Spelling;

/**
 * Codec of a mapping with known keys. The keys are declared as {@link Field}s in the order in which
 * they are written. After the last one, {@link #made} declares how a value is created from the
 * entries that were read.
 *
 * @param <T> the type that the mapping describes
 */
class RecordCodec<T> implements Codec<T> {

  private final String name;
  private final Phrase phrase;
  private final String description;
  private final Map<String, Field<T, ?>> fields = new LinkedHashMap<>();
  private final List<Case> cases = new ArrayList<>();
  private Consumer<Entries> check = in -> {};
  private Function<Entries, T> maker;

  /**
   * Creates a codec without fields.
   *
   * @param name the name of the mapping in the JSON schema
   * @param phrase a noun phrase for users, such as {@code a room}
   * @param description the description for editors
   */
  RecordCodec(String name, Phrase phrase, String description) {
    this.name = name;
    this.phrase = phrase;
    this.description = description;
  }

  /** Starts the declaration of the next key. */
  final Field.Key<T> key(String key, String keyDescription) {
    return new Field.Key<>(key, keyDescription, this::add);
  }

  /** Declares the next key. */
  final void add(Field<T, ?> field) {
    fields.put(field.key(), field);
  }

  /** Declares the next keys. */
  @SafeVarargs
  final void addAll(Field<T, ?>... next) {
    for (Field<T, ?> field : next) {
      add(field);
    }
  }

  /** Declares a rule about keys that require or exclude other keys. */
  final void add(Case rule) {
    cases.add(rule);
  }

  /** The keys in the order in which they are written. */
  final List<String> keys() {
    return List.copyOf(fields.keySet());
  }

  /** Declares a consistency check, which runs only if all values could be read. */
  final void checked(Consumer<Entries> newCheck) {
    check = newCheck;
  }

  /**
   * Declares how a value is created from entries without errors. This must be the last declaration.
   */
  final RecordCodec<T> made(Function<Entries, T> newMaker) {
    maker = newMaker;
    return this;
  }

  /** Returns the style in which the mapping is written. By default, it is written on one line. */
  FlowStyle style() {
    return FlowStyle.FLOW;
  }

  @Override
  public Optional<T> read(Node node, Context context) {
    Entries in = entries(node, context);
    if (in.sound()) {
      check.accept(in);
    }
    return in.sound() ? Optional.of(maker.apply(in)) : Optional.empty();
  }

  /** Reads the values of all keys, and reports any errors. */
  final Entries entries(Node node, Context context) {
    Entries in = new Entries(node, context);
    if (!(node instanceof MappingNode mapping)) {
      context.diagnostics().expected(phrase, node);
      return in;
    }
    for (NodeTuple tuple : mapping.getValue()) {
      take(tuple, in);
    }
    if (checkKeys(in)) {
      for (Field<T, ?> field : fields.values()) {
        in.read(field, phrase);
      }
      for (Case rule : cases) {
        rule.check(in, phrase);
      }
    }
    return in;
  }

  /** Checks the keys as a whole, and returns whether their values can be read. */
  boolean checkKeys(Entries in) {
    return true;
  }

  private void take(NodeTuple tuple, Entries in) {
    Diagnostics diagnostics = in.diagnostics();
    Node key = tuple.getKeyNode();
    if (!(key instanceof ScalarNode scalar)) {
      diagnostics.add(key, Phrase.of("expected a key, found %s", Diagnostics.found(key)));
      return;
    }
    String word = scalar.getValue();
    if (!fields.containsKey(word)) {
      diagnostics.add(Diagnostics.place(key), () -> unknown(word));
    } else if (!in.put(word, tuple.getValueNode())) {
      diagnostics.add(key, Phrase.of("the key %s is there twice", word));
    }
  }

  private Phrase unknown(String key) {
    String shown = Printable.quoted(key);
    return Spelling.meant(key, fields.keySet())
        .map(meant -> Phrase.of("%s has no key %s, did you mean %s?", phrase, shown, meant))
        .orElseGet(
            () ->
                Phrase.of(
                    "%s has no key %s, but only %s",
                    phrase, shown, String.join(", ", fields.keySet())));
  }

  @Override
  public Node write(T value, Path folder) {
    List<NodeTuple> tuples = new ArrayList<>();
    for (Field<T, ?> field : fields.values()) {
      Optional<Node> node = field.write(value, folder);
      if (node.isPresent()) {
        tuples.add(new NodeTuple(Yaml.text(field.key()), node.get()));
      }
    }
    return new MappingNode(Tag.MAP, tuples, style());
  }

  @Override
  public Map<String, Object> schema(Map<String, Object> definitions) {
    if (!definitions.containsKey(name)) {
      definitions.put(name, Map.of()); // registered before the definitions that it refers to
      definitions.put(name, definition(definitions));
    }
    return Codec.object("$ref", "#/$defs/" + name);
  }

  /** Returns the JSON schema of a file that contains this mapping. */
  Map<String, Object> document(String title) {
    Map<String, Object> definitions = new LinkedHashMap<>();
    Map<String, Object> schema =
        Codec.object("$schema", "https://json-schema.org/draft/2020-12/schema", "title", title);
    schema.putAll(definition(definitions));
    schema.put("$defs", definitions);
    return schema;
  }

  /** Returns the JSON schema of the mapping itself, rather than a reference to it. */
  Map<String, Object> definition(Map<String, Object> definitions) {
    Map<String, Object> properties = new LinkedHashMap<>();
    fields.forEach((key, field) -> properties.put(key, field.schema(definitions)));
    Map<String, Object> definition = Codec.object("type", "object");
    definition.put("description", description);
    definition.put("additionalProperties", false);
    definition.put("properties", properties);
    List<String> required = fields.values().stream().filter(Field::needed).map(Field::key).toList();
    if (!required.isEmpty()) {
      definition.put("required", required);
    }
    if (!cases.isEmpty()) {
      definition.put("allOf", cases.stream().map(Case::schema).toList());
    }
    return definition;
  }
}
