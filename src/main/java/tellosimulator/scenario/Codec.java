package tellosimulator.scenario;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.scenario.Field.Usual;

/**
 * How a value is read from a scenario file, written to one, and described to editors. Immutable.
 *
 * @param <T> the value in the program, in SI
 */
interface Codec<T> {

  /**
   * What codecs need to know of the file that they read.
   *
   * @param diagnostics to which they tell what is wrong
   * @param folder from which the file names its pictures
   * @param looked whether a picture that is not there is a mistake
   * @param drones how many there are
   */
  record Context(Diagnostics diagnostics, Path folder, boolean looked, int drones) {

    Context withDrones(int newDrones) {
      return new Context(diagnostics, folder, looked, newDrones);
    }
  }

  /** The value of a node; empty if it has none, which is told to the mistakes of the context. */
  Optional<T> read(Node node, Context context);

  /**
   * The node of a value.
   *
   * @param folder in which the file will be
   */
  Node write(T value, Path folder);

  /**
   * Its JSON schema.
   *
   * @param definitions by name, to which it adds those that it refers to
   */
  Map<String, Object> schema(Map<String, Object> definitions);

  /** The same with a usual value, which is left out of a text. */
  default Usual<T> or(T usual) {
    return new Usual<>(this, usual, false);
  }

  /** The same with a usual value, which is written nevertheless. */
  default Usual<T> orWritten(T usual) {
    return new Usual<>(this, usual, true);
  }

  /** The same for values that these can be converted to, and from. */
  default <U> Codec<U> map(Function<T, U> to, Function<U, T> from) {
    Codec<T> codec = this;
    return new Codec<>() {
      @Override
      public Optional<U> read(Node node, Context context) {
        return codec.read(node, context).map(to);
      }

      @Override
      public Node write(U value, Path folder) {
        return codec.write(from.apply(value), folder);
      }

      @Override
      public Map<String, Object> schema(Map<String, Object> definitions) {
        return codec.schema(definitions);
      }
    };
  }

  /** A JSON object of keys and values in turn, in their order. */
  static Map<String, Object> object(Object... keysAndValues) {
    Map<String, Object> object = new LinkedHashMap<>();
    for (int i = 0; i < keysAndValues.length; i += 2) {
      object.put((String) keysAndValues[i], keysAndValues[i + 1]);
    }
    return object;
  }
}
