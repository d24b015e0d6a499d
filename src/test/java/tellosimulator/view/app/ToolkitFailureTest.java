package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The messages are those of OpenJFX 21.0.12 on Linux, on JDK 17 and 25. */
class ToolkitFailureTest {

  @Test
  void aDisplayThatCannotBeOpenedIsNoDisplay() {
    assertThat(because(new UnsupportedOperationException("Unable to open DISPLAY")))
        .isEqualTo(ToolkitFailure.NO_DISPLAY);
  }

  @ParameterizedTest
  @ValueSource(strings = {"Unable to load glass GTK library.", "No toolkit found"})
  void whatTheToolkitSaysWithoutGtkOrPipelinesIsMissingLibraries(String message) {
    assertThat(because(new UnsupportedOperationException(message)))
        .isEqualTo(ToolkitFailure.MISSING_LIBRARIES);
  }

  @Test
  void aLinkErrorInsideAnotherFailureIsMissingLibraries() {
    Error inside = new UnsatisfiedLinkError("no glassgtk3 in java.library.path: /usr/lib");

    assertThat(because(new RuntimeException(inside))).isEqualTo(ToolkitFailure.MISSING_LIBRARIES);
    assertThat(because(inside)).isEqualTo(ToolkitFailure.MISSING_LIBRARIES);
    assertThat(ToolkitFailure.MISSING_LIBRARIES.sentence())
        .contains("libgtk-3-0", "libgl1", "gtk3", "mesa-dri-drivers");
    assertThat(ToolkitFailure.MISSING_LIBRARIES.cause())
        .startsWith("The window needs system libraries that are missing. On Debian")
        .contains("libgtk-3-0", "gtk3");
  }

  @Test
  void aJarOfAnotherSystemIsToldApartFromMissingLibraries() {
    Error failure = new UnsatisfiedLinkError("no glass in java.library.path: /usr/lib");

    assertThat(ToolkitFailure.because(failure, false)).isEqualTo(ToolkitFailure.OTHER_SYSTEM);
  }

  @Test
  void whatNobodyHasSeenYetIsNotGuessedAt() {
    assertThat(because(new IllegalStateException())).isEqualTo(ToolkitFailure.UNKNOWN);
  }

  @ParameterizedTest
  @EnumSource
  void eachSaysThatTheSimulatorRunsAllTheSame(ToolkitFailure reason) {
    assertThat(reason.sentence().toLowerCase(Locale.ROOT))
        .contains("so the simulator runs without", "window")
        .endsWith(".");
    assertThat(reason.cause())
        .as("for what cannot run without")
        .doesNotContain("simulator runs", "--headless")
        .endsWith(".");
  }

  private static ToolkitFailure because(Throwable failure) {
    return ToolkitFailure.because(failure, true);
  }
}
