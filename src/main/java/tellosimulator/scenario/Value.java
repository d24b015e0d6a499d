package tellosimulator.scenario;

import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;

/**
 * How a value is read; what cannot be read is told to the mistakes, and empty.
 *
 * @param <T> what it becomes
 */
@FunctionalInterface
interface Value<T> {

  Optional<T> read(Node node, Mistakes mistakes);
}
