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
 * A key of a mapping, and the value under it. Immutable.
 *
 * @param <T> what the mapping describes
 * @param <V> the value
 * @param getter the value to write; empty for none
 * @param usual what it is if the key is not there; empty for nothing
 * @param needed whether the key must be there
 */
record Field<T, V>(
    Key<T> name,
    Codec<V> codec,
    Function<T, Optional<V>> getter,
    Optional<Usual<V>> usual,
    boolean needed) {

  /**
   * A codec and what it means if its key is not there.
   *
   * @param value the usual one
   * @param written whether it is written nevertheless, rather than left out
   */
  record Usual<V>(Codec<V> codec, V value, boolean written) {

    private boolean leftOut(V other, Node node, Path folder) {
      return !written
          && (value.equals(other) || ScenarioPatch.same(node, codec.write(value, folder)));
    }
  }

  /**
   * A key to which the codec of its value is still to come.
   *
   * @param description for editors; empty for none
   * @param owner gets to know the field
   */
  record Key<T>(String key, String description, Consumer<Field<T, ?>> owner) {

    /** It must be there. */
    <V> Field<T, V> need(Codec<V> codec, Function<T, V> getter) {
      return added(codec, getter.andThen(Optional::of), Optional.empty(), true);
    }

    /** It has a usual value. */
    <V> Field<T, V> usual(Usual<V> usual, Function<T, V> getter) {
      return optional(usual, getter.andThen(Optional::of));
    }

    /** It has a usual value, but is not written of everything. */
    <V> Field<T, V> optional(Usual<V> usual, Function<T, Optional<V>> getter) {
      return added(usual.codec(), getter, Optional.of(usual), false);
    }

    /** It can be there. */
    <V> Field<T, V> optional(Codec<V> codec, Function<T, Optional<V>> getter) {
      return added(codec, getter, Optional.empty(), false);
    }

    /** It can be there; of a number. */
    Field<T, Integer> optionalInt(Codec<Integer> codec, Function<T, OptionalInt> getter) {
      return optional(
          codec,
          described -> {
            OptionalInt value = getter.apply(described);
            return value.isPresent() ? Optional.of(value.getAsInt()) : Optional.empty();
          });
    }

    private <V> Field<T, V> added(
        Codec<V> codec, Function<T, Optional<V>> getter, Optional<Usual<V>> usual, boolean needed) {
      Field<T, V> field = new Field<>(this, codec, getter, usual, needed);
      owner.accept(field);
      return field;
    }
  }

  String key() {
    return name.key();
  }

  /** The node of the value that something has, marked if it is left out of a text. */
  Optional<Node> write(T described, Path folder) {
    Optional<V> value = getter.apply(described);
    return value.map(
        present -> {
          Node node = codec.write(present, folder);
          return Yaml.marked(
              node, usual.filter(any -> any.leftOut(present, node, folder)).isPresent());
        });
  }

  /** The JSON schema of the value. */
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
