package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import tellosimulator.scenario.Field.Default;

/**
 * Reads and writes one kind of value in scenario files, and describes it to text editors with a
 * JSON schema. Immutable.
 *
 * @param <T> the type of the value in the program, where all quantities are in SI units
 */
interface Codec<T> {

  /**
   * The properties of a file that codecs need when reading it.
   *
   * @param diagnostics receives the errors
   * @param folder the folder to which the names of image files are relative
   * @param looked whether a missing image file is an error
   * @param drones the number of drones in the file
   * @param draw the random numbers for ranges
   */
  record Context(
      Diagnostics diagnostics, Path folder, boolean looked, int drones, CourseDraw draw) {

    Context withDrones(int newDrones) {
      return new Context(diagnostics, folder, looked, newDrones, draw);
    }
  }

  /**
   * Reads the value of a node. If it is invalid, reports an error to the context and returns empty.
   */
  Optional<T> read(Node node, Context context);

  /**
   * Returns the node of a value.
   *
   * @param folder the folder that will contain the file
   */
  Node write(T value, Path folder);

  /**
   * Returns the JSON schema of the value.
   *
   * @param definitions all definitions by name; receives the definitions to which the schema refers
   */
  Map<String, Object> schema(Map<String, Object> definitions);

  /** Returns this codec with a default value that is omitted when writing. */
  default Default<T> or(T usual) {
    return new Default<>(this, usual, false);
  }

  /** Returns this codec with a default value that is written like any other value. */
  default Default<T> orWritten(T usual) {
    return new Default<>(this, usual, true);
  }

  /**
   * Returns a codec for values of another type, which are converted to and from values of this
   * codec.
   */
  default <U> Codec<U> map(Function<T, U> to, Function<U, T> from) {
    return new Composed<>(
        (node, context) -> read(node, context).map(to),
        (value, folder) -> write(from.apply(value), folder),
        this::schema);
  }

  /** Returns a codec that reads values by a function, and otherwise works like this one. */
  default Codec<T> readBy(BiFunction<Node, Context, Optional<T>> reader) {
    return new Composed<>(reader, this::write, this::schema);
  }

  /** Returns this codec with a short form: a scalar, which is read but never written. */
  default Codec<T> orShort(Codec<T> scalar) {
    return new Composed<>(
        (node, context) -> (node instanceof ScalarNode ? scalar : this).read(node, context),
        this::write,
        definitions -> object("anyOf", List.of(scalar.schema(definitions), schema(definitions))));
  }

  /**
   * A codec made of functions.
   *
   * @param reader reads a value, see {@link Codec#read}
   * @param writer writes a value, see {@link Codec#write}
   * @param describer describes the values, see {@link Codec#schema}
   */
  record Composed<T>(
      BiFunction<Node, Context, Optional<T>> reader,
      BiFunction<T, Path, Node> writer,
      UnaryOperator<Map<String, Object>> describer)
      implements Codec<T> {

    @Override
    public Optional<T> read(Node node, Context context) {
      return reader.apply(node, context);
    }

    @Override
    public Node write(T value, Path folder) {
      return writer.apply(value, folder);
    }

    @Override
    public Map<String, Object> schema(Map<String, Object> definitions) {
      return describer.apply(definitions);
    }
  }

  /**
   * Returns a JSON object with the given keys and values in order.
   *
   * @param keysAndValues keys and values, alternating
   */
  static Map<String, Object> object(Object... keysAndValues) {
    Map<String, Object> object = new LinkedHashMap<>();
    for (int i = 0; i < keysAndValues.length; i += 2) {
      object.put((String) keysAndValues[i], keysAndValues[i + 1]);
    }
    return object;
  }
}
