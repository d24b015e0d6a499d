package tellosimulator.view.testing;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.testfx.api.FxToolkit;

/** Whether there is a display that can do 3D, as {@link NeedsDisplay} asks. */
final class DisplayCondition implements ExecutionCondition {

  private static final String NO_DISPLAY =
      "There is no display: neither DISPLAY nor WAYLAND_DISPLAY is set."
          + " Try xvfb-run mvn test, or see .ci/run.";

  private static final String NO_3D =
      "The display cannot do 3D: JavaFX needs OpenGL, for example that of Mesa"
          + " (package libgl1-mesa-dri).";

  @Override
  public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
    Optional<String> missing =
        missing(System.getProperty("os.name"), System.getenv(), DisplayCondition::toolkitCanDo3D);
    missing.ifPresent(
        sentence -> System.err.println(context.getDisplayName() + " is not run. " + sentence));
    return verdict(missing, System.getenv());
  }

  /** Skips, or fails on a build server, if something is missing. */
  static ConditionEvaluationResult verdict(
      Optional<String> missing, Map<String, String> environment) {
    if (missing.isPresent() && environment.getOrDefault("CI", "").equals("true")) {
      throw new IllegalStateException(
          missing.get() + " On a build server (CI=true) this test must not be skipped.");
    }
    return missing
        .map(ConditionEvaluationResult::disabled)
        .orElseGet(() -> ConditionEvaluationResult.enabled("there is a display with 3D"));
  }

  /** What is missing, as a sentence; does not ask the toolkit if there is no display at all. */
  static Optional<String> missing(
      String system, Map<String, String> environment, BooleanSupplier toolkitCanDo3D) {
    boolean displayIsNamed =
        !system.toLowerCase(Locale.ROOT).contains("linux")
            || environment.containsKey("DISPLAY")
            || environment.containsKey("WAYLAND_DISPLAY");
    if (!displayIsNamed) {
      return Optional.of(NO_DISPLAY);
    }
    return toolkitCanDo3D.getAsBoolean() ? Optional.empty() : Optional.of(NO_3D);
  }

  private static boolean toolkitCanDo3D() {
    try {
      FxToolkit.registerPrimaryStage();
      return Platform.isSupported(ConditionalFeature.SCENE3D);
    } catch (TimeoutException e) {
      throw new IllegalStateException("the toolkit does not start on this display", e);
    }
  }
}
