package tellosimulator.log;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.LoggingEvent;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import org.junit.jupiter.api.Test;

class LogLayoutTest {

  private final LogLayout layout = new LogLayout();

  private String line(Level level, String message, Throwable thrown, Object... arguments) {
    LoggingEvent event =
        new LoggingEvent(
            LogLayoutTest.class.getName(),
            new LoggerContext().getLogger("tellosimulator.test"),
            level,
            message,
            thrown,
            arguments);
    Instant afternoon =
        LocalDateTime.of(2026, 11, 21, 14, 3, 7, 95_999_999)
            .atZone(ZoneId.systemDefault())
            .toInstant();
    event.setInstant(afternoon);
    return layout.doLayout(event);
  }

  @Test
  void messagesStandBelowEachOtherBehindTimeAndLevel() {
    assertThat(line(Level.INFO, "drone {} is on", null, 1))
        .isEqualTo("14:03:07.095 INFO  drone 1 is on" + System.lineSeparator());
    assertThat(line(Level.ERROR, "no", null))
        .isEqualTo("14:03:07.095 ERROR no" + System.lineSeparator());
  }

  @Test
  void textFromOutsideNeitherCommandsTheTerminalNorLooksLikeAMessage() {
    assertThat(line(Level.INFO, "`{}`", null, "\u001b[2J\u202e\n14:03:07.095 INFO  fine"))
        .isEqualToNormalizingNewlines(
            "14:03:07.095 INFO  `\\x1b[2J\\u202e\n\t14:03:07.095 INFO  fine`\n");
    assertThat(line(Level.WARN, "failed", new IllegalStateException("\u001b[2J")))
        .contains("IllegalStateException: \\x1b[2J");
  }

  @Test
  void anExceptionIsNamedWithWhereItWasThrown() {
    String line = line(Level.WARN, "failed", new IllegalStateException("because"));

    assertThat(line.lines())
        .hasSize(3)
        .contains("14:03:07.095 WARN  failed", "java.lang.IllegalStateException: because");
    assertThat(line.lines().skip(2).findFirst().orElseThrow())
        .startsWith("\tat tellosimulator.log.LogLayoutTest.");
  }
}
