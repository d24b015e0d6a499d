package tellosimulator.comparison;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import tellosimulator.comparison.Tolerance.Aspect;

/**
 * A command of two flights. Immutable; for any thread.
 *
 * @param first in the first flight; empty if it was not sent there
 * @param second in the second flight; empty if it was not sent there
 * @param differing in what they differ; empty if they are alike
 */
public record CommandPair(
    Optional<FlownCommand> first, Optional<FlownCommand> second, Set<Aspect> differing) {

  public CommandPair {
    differing = Set.copyOf(differing);
  }

  /** As it was sent. */
  public String text() {
    return either().command().text();
  }

  /** Whether it differs in nothing. */
  public boolean alike() {
    return differing.isEmpty();
  }

  /** To which drone, from 1. */
  public int drone() {
    return either().command().drone();
  }

  private FlownCommand either() {
    return Stream.of(first, second).flatMap(Optional::stream).findFirst().orElseThrow();
  }
}
