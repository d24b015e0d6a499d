package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.Function;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;

/**
 * A key of a mapping and its value. Immutable.
 *
 * @param <T> the type that the mapping describes
 * @param <V> the type of the value
 * @param getter returns the value to be written; empty if the key is not written
 * @param usual the default if the key is missing; empty if there is none
 * @param needed whether the key is required
 */
record Field<T, V>(
    Key<T> name,
    Codec<V> codec,
    Function<T, Optional<V>> getter,
    Optional<Default<V>> usual,
    boolean needed) {

  /**
   * A codec and the default for a missing key.
   *
   * @param value the default value
   * @param written whether the default is written rather than omitted
   */
  record Default<V>(Codec<V> codec, V value, boolean written) {

    private boolean leftOut(V other, Node node, Path folder) {
      return !written
          && (value.equals(other) || ScenarioPatch.same(node, codec.write(value, folder)));
    }
  }

  /**
   * A key that has no codec yet.
   *
   * @param description the description for editors; may be empty
   * @param owner receives the field once its codec is known
   */
  record Key<T>(String key, String description, Consumer<Field<T, ?>> owner) {

    /** Makes the key required. */
    <V> Field<T, V> need(Codec<V> codec, Function<T, V> getter) {
      return added(codec, getter.andThen(Optional::of), Optional.empty(), true);
    }

    /** Makes the key optional with a default. */
    <V> Field<T, V> usual(Default<V> usual, Function<T, V> getter) {
      return optional(usual, getter.andThen(Optional::of));
    }

    /**
     * Makes the key optional with a default; the value is written only if the getter returns one.
     */
    <V> Field<T, V> optional(Default<V> usual, Function<T, Optional<V>> getter) {
      return added(usual.codec(), getter, Optional.of(usual), false);
    }

    /** Makes the key optional. */
    <V> Field<T, V> optional(Codec<V> codec, Function<T, Optional<V>> getter) {
      return added(codec, getter, Optional.empty(), false);
    }

    /** Makes the key optional, with a number as its value. */
    Field<T, Integer> optionalInt(Codec<Integer> codec, Function<T, OptionalInt> getter) {
      return optional(
          codec,
          described -> {
            OptionalInt value = getter.apply(described);
            return value.isPresent() ? Optional.of(value.getAsInt()) : Optional.empty();
          });
    }

    private <V> Field<T, V> added(
        Codec<V> codec,
        Function<T, Optional<V>> getter,
        Optional<Default<V>> usual,
        boolean needed) {
      Field<T, V> field = new Field<>(this, codec, getter, usual, needed);
      owner.accept(field);
      return field;
    }
  }

  String key() {
    return name.key();
  }

  /**
   * Returns the node of the value; empty if there is no value. If the value is a default to be
   * omitted from the text, the node is marked as a default.
   */
  Optional<Node> write(T described, Path folder) {
    Optional<V> value = getter.apply(described);
    return value.map(
        present -> {
          Node node = codec.write(present, folder);
          return Yaml.marked(
              node, usual.filter(any -> any.leftOut(present, node, folder)).isPresent());
        });
  }

  /** Returns the JSON schema of the value. */
  Map<String, Object> schema(Map<String, Object> definitions) {
    Map<String, Object> schema = codec.schema(definitions);
    if (!name.description().isEmpty()) {
      schema.put("description", name.description());
    }
    usual
        .map(any -> codec.write(any.value(), Path.of("")))
        .filter(ScalarNode.class::isInstance)
        .ifPresent(node -> schema.put("default", json((ScalarNode) node)));
    return schema;
  }

  private static Object json(ScalarNode node) {
    if (node.getTag().equals(Tag.STR)) {
      return node.getValue();
    }
    return node.getTag().equals(Tag.BOOL)
        ? (Object) Boolean.valueOf(node.getValue())
        : new java.math.BigDecimal(node.getValue());
  }
}
