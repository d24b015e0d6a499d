package tellosimulator.view.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class DisplayConditionTest {

  private static final Map<String, String> AT_A_DESK = Map.of();
  private static final Map<String, String> ON_A_BUILD_SERVER = Map.of("CI", "true");

  @Test
  void whatIsMissingSkipsAtADeskAndFailsOnABuildServer() {
    Optional<String> missing = Optional.of("No display.");

    assertThat(DisplayCondition.verdict(missing, AT_A_DESK).isDisabled()).isTrue();
    assertThat(DisplayCondition.verdict(missing, AT_A_DESK).getReason()).contains("No display.");
    assertThatThrownBy(() -> DisplayCondition.verdict(missing, ON_A_BUILD_SERVER))
        .hasMessageStartingWith("No display.");
  }

  @Test
  void whereNothingIsMissingTheTestRuns() {
    assertThat(DisplayCondition.verdict(Optional.empty(), ON_A_BUILD_SERVER).isDisabled())
        .isFalse();
  }

  @Test
  void withoutADisplayTheToolkitIsNotAsked() {
    assertThat(DisplayCondition.missing("Linux", Map.of(), DisplayConditionTest::neverAsked))
        .get()
        .asString()
        .contains("DISPLAY is set");
  }

  @Test
  void aDisplayMustDo3D() {
    Map<String, String> display = Map.of("DISPLAY", ":0");

    assertThat(DisplayCondition.missing("Linux", display, () -> false))
        .get()
        .asString()
        .contains("libgl1-mesa-dri");
    assertThat(DisplayCondition.missing("Linux", display, () -> true)).isEmpty();
    assertThat(DisplayCondition.missing("Windows 11", Map.of(), () -> true)).isEmpty();
  }

  private static boolean neverAsked() {
    throw new AssertionError("the toolkit was asked");
  }
}
