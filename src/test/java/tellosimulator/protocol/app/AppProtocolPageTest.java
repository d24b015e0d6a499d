package tellosimulator.protocol.app;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import tellosimulator.testing.GeneratedPage;

/** Checks that the page about the app's protocol says what the table of messages says. */
class AppProtocolPageTest {

  private static final GeneratedPage PAGE = new GeneratedPage("app-protocol");

  @Test
  void pageSaysWhatTheTableSays() {
    PAGE.check(PAGE.template().replace("{{messages}}", messages()), AppProtocolPageTest.class);
  }

  private static String messages() {
    StringBuilder table =
        new StringBuilder("| id | message | sent by | known from |\n|---|---|---|---|");
    for (MessageId id : MessageId.values()) {
      String sender =
          switch (id.sender()) {
            case APP -> "app";
            case DRONE -> "drone";
            case BOTH -> "both";
          };
      table.append(
          String.format(
              Locale.ROOT,
              "%n| `%04X` | %s | %s | %s |",
              id.number(),
              id.words(),
              sender,
              id.source()));
    }
    return table.toString();
  }
}
