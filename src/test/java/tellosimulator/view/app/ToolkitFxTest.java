package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.testfx.api.FxToolkit;
import tellosimulator.view.testing.FxFailures;

@Timeout(value = 120, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ToolkitFxTest {

  private FxFailures failures;

  @BeforeEach
  void catchFailures() throws TimeoutException {
    FxToolkit.registerPrimaryStage();
    failures = new FxFailures();
  }

  @AfterEach
  void release() {
    failures.close();
  }

  @Test
  void aWindowThatWasClosedWasShown() throws InterruptedException {
    assertThat(
            Toolkit.showUntilClosed(
                stage -> {
                  stage.show();
                  stage.hide();
                }))
        .isTrue();
  }

  @ParameterizedTest
  @MethodSource
  void whateverIsThrownWhileItIsShownEndsTheWait(Throwable failure) throws InterruptedException {
    assertThat(Toolkit.showUntilClosed(stage -> fail(stage, failure))).isFalse();
    assertThat(failures.next()).isSameAs(failure);
  }

  static Stream<Throwable> whateverIsThrownWhileItIsShownEndsTheWait() {
    return Stream.of(
        new IllegalStateException("broken on purpose"),
        new NoClassDefFoundError("broken/on/purpose"),
        new StackOverflowError());
  }

  private static void fail(Stage stage, Throwable failure) {
    stage.setTitle("never seen");
    if (failure instanceof Error error) {
      throw error;
    }
    throw (RuntimeException) failure;
  }
}
