package tellosimulator.scenario;

import java.util.List;
import java.util.stream.Collectors;

/** A scenario file that cannot be used; its message has a line for each mistake. */
public final class ScenarioException extends Exception {

  private static final long serialVersionUID = 1;

  private final transient List<Mistake> mistakes;

  ScenarioException(List<Mistake> mistakes) {
    super(mistakes.stream().map(Mistake::toString).collect(Collectors.joining("\n")));
    this.mistakes = List.copyOf(mistakes);
  }

  /** What is wrong, in the order of the places; at least one. */
  public List<Mistake> mistakes() {
    return mistakes;
  }
}
