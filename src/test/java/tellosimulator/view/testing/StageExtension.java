package tellosimulator.view.testing;

import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.settle;

import java.lang.reflect.Method;
import java.util.concurrent.TimeoutException;
import javafx.stage.Stage;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.junit.platform.commons.support.AnnotationSupport;
import org.junit.platform.commons.support.HierarchyTraversalMode;
import org.testfx.api.FxRobot;
import org.testfx.api.FxToolkit;
import org.testfx.framework.junit5.Start;
import org.testfx.util.WaitForAsyncUtils;

/**
 * Does what TestFX's {@code ApplicationExtension} does, with a {@link QuickRobot}: calls each
 * method with {@link Start} with a stage of the test's own on the JavaFX thread, and closes all
 * windows in the end.
 */
public final class StageExtension
    implements BeforeEachCallback, AfterEachCallback, ParameterResolver {

  @Override
  public void beforeEach(ExtensionContext test) throws TimeoutException {
    FxToolkit.registerPrimaryStage();
    Object instance = test.getRequiredTestInstance();
    for (Method start :
        AnnotationSupport.findAnnotatedMethods(
            instance.getClass(), Start.class, HierarchyTraversalMode.TOP_DOWN)) {
      start.setAccessible(true);
      onFxThread(() -> start.invoke(instance, new Stage()));
    }
    settle();
  }

  @Override
  public void afterEach(ExtensionContext test) {
    onFxThread(
        () -> {
          WindowFixture.closeWindows();
          return true;
        });
    WaitForAsyncUtils.clearExceptions();
  }

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext test) {
    return parameter.getParameter().getType() == FxRobot.class;
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext test) {
    return new QuickRobot();
  }
}
