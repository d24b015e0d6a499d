package tellosimulator.testing;

import java.lang.management.ManagementFactory;
import java.lang.management.OperatingSystemMXBean;
import java.util.Locale;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * Skips the tests of the window, whose classes end with {@code FxTest}, while the machine is busy
 * with other work: a window that gets too little processor time does not react within a minute, and
 * the failure would say nothing about the window. With {@code CI=true} in the environment, the
 * tests always run. JUnit registers the condition for each test automatically, as a service.
 */
public final class QuietMachine implements ExecutionCondition {

  /**
   * The load above which a machine is busy [runnable threads for each processor]. Measured: the
   * tests of the window alone cause a load of up to 2 on a machine with two processors.
   */
  private static final double BUSY = 3;

  @Override
  public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
    boolean window =
        context.getTestMethod().isEmpty()
            && context.getTestClass().filter(type -> type.getName().endsWith("FxTest")).isPresent();
    OperatingSystemMXBean system = ManagementFactory.getOperatingSystemMXBean();
    return window && !"true".equals(System.getenv("CI"))
        ? verdict(system.getSystemLoadAverage(), system.getAvailableProcessors())
        : ConditionEvaluationResult.enabled("needs no quiet machine");
  }

  /**
   * Decides whether a machine is quiet enough.
   *
   * @param load the average number of runnable threads in the last minute; negative if unknown
   */
  static ConditionEvaluationResult verdict(double load, int processors) {
    return load > BUSY * processors
        ? ConditionEvaluationResult.disabled(
            String.format(
                Locale.ROOT,
                "needs a quiet machine: a load of at most %.0f, with no other work at the same time",
                BUSY * processors))
        : ConditionEvaluationResult.enabled("the machine is quiet");
  }
}
