package tellosimulator.scenario;

import java.util.List;
import java.util.stream.Collectors;

/** A scenario file that cannot be used; its message has a line for each mistake. */
public final class ScenarioException extends Exception {

  private static final long serialVersionUID = 1;

  private final transient List<Diagnostic> diagnostics;

  ScenarioException(List<Diagnostic> diagnostics) {
    super(diagnostics.stream().map(Diagnostic::toString).collect(Collectors.joining("\n")));
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** What is wrong, in the order of the places; at least one. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }
}
