package tellosimulator.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import tellosimulator.concurrent.ErrorPolicy;

/** JUnit provides the parameter only if it has registered the extension automatically. */
class UnexpectedErrorsTest {

  private final Exception broken = new IllegalStateException("broken on purpose");
  private static final ErrorPolicy FAILED = ErrorPolicy.goOn("A test");

  @Test
  void aTestThatLogsAnErrorToReportFails(UnexpectedErrors errors) {
    FAILED.tell(broken);

    assertThatThrownBy(() -> errors.afterEach(null))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("A test; please report this: ")
        .hasMessageContaining("broken on purpose");
    assertThatCode(() -> errors.afterEach(null)).doesNotThrowAnyException();
  }

  @Test
  void aTestThatLooksForItPasses(UnexpectedErrors errors) throws InterruptedException {
    try (CapturedLog log = CapturedLog.of(ErrorPolicy.class)) {
      FAILED.tell(broken);
      assertThat(log.next()).startsWith("A test; please report this: ");
    }

    assertThatCode(() -> errors.afterEach(null)).doesNotThrowAnyException();
  }

  @Test
  void aTestThatOnlyHidesItFails() {
    CapturedLog log = CapturedLog.of(ErrorPolicy.class);
    FAILED.tell(broken);

    assertThatThrownBy(log::close)
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("A test; please report this: ");
  }
}
