package tellosimulator.concurrent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.filter.Filter;
import ch.qos.logback.core.spi.FilterReply;
import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import tellosimulator.testing.CapturedLog;

/** Tests the messages about failures. */
class ErrorPolicyTest {

  private final CapturedLog log = CapturedLog.of(ErrorPolicy.class);
  private final ErrorPolicy policy = ErrorPolicy.goOn("A picture failed");

  @AfterEach
  void close() {
    log.close();
  }

  @Test
  void fullMemoryComesWithWhatHelps() throws InterruptedException {
    policy.tell(new OutOfMemoryError("Java heap space"));

    assertThat(log.next())
        .isEqualTo(
            "A picture failed: memory is full; give the program more, such as"
                + " java -Xmx"
                + 2 * (Runtime.getRuntime().maxMemory() >> 20)
                + "m -jar tello-simulator.jar");
  }

  @Test
  void inputAndOutputThatFailIsAWarning() throws InterruptedException {
    policy.tell(new IOException("no route"));

    ILoggingEvent event = log.event();
    assertThat(event.getFormattedMessage()).isEqualTo("A picture failed: no route");
    assertThat(event.getLevel()).isEqualTo(Level.WARN);

    policy.tell(new IOException());
    assertThat(log.next()).isEqualTo("A picture failed: the system does not say why");
  }

  @Test
  void whatShouldNotBeIsToReportWithTheNumberOfThoseThatWereNotTold() throws InterruptedException {
    policy.tell(new StackOverflowError(), 312);

    ILoggingEvent event = log.event();
    assertThat(event.getFormattedMessage())
        .isEqualTo(
            "A picture failed (312 more times since the last message); please report this:"
                + " java.lang.StackOverflowError");
    assertThat(event.getLevel()).isEqualTo(Level.ERROR);
  }

  @Test
  void anErrorInTheLogIsNotPassedOn() {
    log.addFilter(
        new Filter<>() {
          @Override
          public FilterReply decide(ILoggingEvent event) {
            throw new OutOfMemoryError("broken on purpose");
          }
        });

    assertThatCode(() -> policy.tell(new OutOfMemoryError())).doesNotThrowAnyException();
    assertThat(log.isEmpty()).isTrue();
  }
}
