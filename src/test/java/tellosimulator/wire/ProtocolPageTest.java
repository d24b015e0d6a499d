package tellosimulator.wire;

import org.junit.jupiter.api.Test;

class ProtocolPageTest {

  @Test
  void pageSaysWhatTheTablesSay() {
    ProtocolPage.PAGE.check(ProtocolPage.text(), ProtocolPageTest.class);
  }
}
