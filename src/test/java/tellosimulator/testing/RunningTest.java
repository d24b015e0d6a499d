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
 * The test that is running in this JVM, for {@link Tool} and {@link Jvm}, which start processes
 * only for tests that declare them. JUnit registers it for each test automatically, as a service;
 * tests of one JVM run sequentially.
 */
public final class RunningTest
    implements BeforeAllCallback, BeforeEachCallback, AfterEachCallback, AfterAllCallback {

  private static volatile Optional<ExtensionContext> running = Optional.empty();

  /** Returns whether the running test, its class or an enclosing class declares a tool. */
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

  /** Returns whether the running test or its class has a tag. */
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
