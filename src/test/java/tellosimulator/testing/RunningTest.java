package tellosimulator.testing;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.platform.commons.support.AnnotationSupport;

/**
 * The test that runs in this JVM, for {@link Tool} and {@link Jvm}, which start processes only for
 * tests that say so. JUnit registers it for each test by itself, as a service; tests of one JVM run
 * one after the other.
 */
public final class RunningTest
    implements BeforeAllCallback, BeforeEachCallback, AfterEachCallback, AfterAllCallback {

  private static volatile Optional<ExtensionContext> running = Optional.empty();

  /** Whether the running test, its class or a class around it names a tool. */
  static boolean names(Tool tool) {
    Set<Tool> named = EnumSet.noneOf(Tool.class);
    for (Optional<ExtensionContext> at = running;
        at.isPresent();
        at = at.flatMap(ExtensionContext::getParent)) {
      AnnotationSupport.findAnnotation(at.get().getElement(), NeedsTool.class)
          .ifPresent(needed -> named.addAll(Arrays.asList(needed.value())));
    }
    return named.contains(tool);
  }

  /** Whether the running test has a tag, by itself or by its class. */
  static boolean isTagged(String tag) {
    return running.map(test -> test.getTags().contains(tag)).orElse(false);
  }

  @Override
  public void beforeAll(ExtensionContext context) {
    running = Optional.of(context);
  }

  @Override
  public void beforeEach(ExtensionContext context) {
    running = Optional.of(context);
  }

  @Override
  public void afterEach(ExtensionContext context) {
    running = context.getParent();
  }

  @Override
  public void afterAll(ExtensionContext context) {
    running = context.getParent();
  }
}
