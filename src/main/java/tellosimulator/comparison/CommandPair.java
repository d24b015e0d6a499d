package tellosimulator.comparison;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import tellosimulator.comparison.Tolerance.Aspect;

/**
 * A pair of corresponding commands in two flights. Immutable.
 *
 * @param first the command in the first flight; empty if it was not sent in that flight
 * @param second the command in the second flight; empty if it was not sent in that flight
 * @param differing the aspects in which the two commands differ; empty if they are alike
 */
public record CommandPair(
    Optional<FlownCommand> first, Optional<FlownCommand> second, Set<Aspect> differing) {

  public CommandPair {
    differing = Set.copyOf(differing);
  }

  /** The text of the command; in words if it is a packet of the app's protocol. */
  public String text() {
    return either().command().words();
  }

  /** Whether the two commands agree in all aspects. */
  public boolean alike() {
    return differing.isEmpty();
  }

  /** The drone's number, from 1. */
  public int drone() {
    return either().command().drone();
  }

  private FlownCommand either() {
    return Stream.of(first, second).flatMap(Optional::stream).findFirst().orElseThrow();
  }
}
