package tellosimulator.scenario;

import java.util.List;
import java.util.stream.Collectors;

/** Thrown if a scenario file cannot be used. The message has a line for each error. */
public final class ScenarioException extends Exception {

  private static final long serialVersionUID = 1;

  private final transient List<Diagnostic> diagnostics;

  ScenarioException(List<Diagnostic> diagnostics) {
    super(diagnostics.stream().map(Diagnostic::toString).collect(Collectors.joining("\n")));
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** Returns all errors, sorted by position. There is at least one. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }
}
