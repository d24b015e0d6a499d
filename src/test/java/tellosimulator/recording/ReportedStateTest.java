package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReportedStateTest {

  @Test
  void fieldsThatAreOneNumberAreReadInTheirOrder() {
    assertThat(ReportedState.numbers("mid:-2;mpry:0,0,0;yaw:-26;baro:1.50;\r\n"))
        .containsExactly(Map.entry("mid", -2.0), Map.entry("yaw", -26.0), Map.entry("baro", 1.5));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", ";;", "h", "h:", ":5;", "h:NaN", "h:1e5", "h: 5", "h:5x", "h:--5", "h:0x10p1"})
  void whatIsDamagedIsLeftOut(String text) {
    assertThat(ReportedState.numbers(text)).isEmpty();
  }
}
