package tellosimulator.testing;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;

/** Checks whether the programs declared by {@link NeedsTool} are available. */
final class ToolCondition implements ExecutionCondition {

  @Override
  public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
    Optional<Tool> missing =
        AnnotationSupport.findAnnotation(context.getElement(), NeedsTool.class).stream()
            .flatMap(needed -> Arrays.stream(needed.value()))
            .filter(tool -> !tool.works())
            .findFirst();
    return verdict(missing, "true".equals(System.getenv("CI")));
  }

  /** Skips a test whose tool is missing; fails it on a build server, which installs all tools. */
  static ConditionEvaluationResult verdict(Optional<Tool> missing, boolean buildServer) {
    if (missing.isEmpty()) {
      return ConditionEvaluationResult.enabled("all tools are there");
    }
    Tool tool = missing.get();
    String reason = "needs " + tool.name() + ": " + tool.install();
    if (buildServer && !tool.canBeForbidden()) {
      throw new IllegalStateException(reason + " (with CI=true this test must not be skipped)");
    }
    return ConditionEvaluationResult.disabled(reason);
  }
}
