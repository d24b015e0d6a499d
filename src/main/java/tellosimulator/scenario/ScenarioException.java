package tellosimulator.scenario;

import java.util.List;
import java.util.stream.Collectors;

/** A scenario file that cannot be used; its message has a line for each mistake. */
public final class ScenarioException extends Exception {

  private static final long serialVersionUID = 1;

  private final transient List<Diagnostic> mistakes;

  ScenarioException(List<Diagnostic> mistakes) {
    super(mistakes.stream().map(Diagnostic::toString).collect(Collectors.joining("\n")));
    this.mistakes = List.copyOf(mistakes);
  }

  /** What is wrong, in the order of the places; at least one. */
  public List<Diagnostic> mistakes() {
    return mistakes;
  }
}
