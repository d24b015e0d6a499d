package tellosimulator.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;

class ProtocolPageTest {

  @Test
  void pageSaysWhatTheTablesSay() throws IOException {
    String text = ProtocolPage.text();
    if (Boolean.getBoolean("update.docs")) {
      Files.writeString(ProtocolPage.FILE, text);
    }

    assertThat(Files.readString(ProtocolPage.FILE))
        .as(
            "%s is stale; renew it with: mvn test -Dtest=ProtocolPageTest -Dupdate.docs=true",
            ProtocolPage.FILE)
        .isEqualTo(text);
  }
}
