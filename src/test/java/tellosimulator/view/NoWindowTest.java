package tellosimulator.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The messages are those of OpenJFX 21.0.12 on Linux, on JDK 17 and 25. */
class NoWindowTest {

  @Test
  void aDisplayThatCannotBeOpenedIsNoDisplay() {
    assertThat(because(new UnsupportedOperationException("Unable to open DISPLAY")))
        .isEqualTo(NoWindow.NO_DISPLAY);
  }

  @ParameterizedTest
  @ValueSource(strings = {"Unable to load glass GTK library.", "No toolkit found"})
  void whatTheToolkitSaysWithoutGtkOrPipelinesIsMissingLibraries(String message) {
    assertThat(because(new UnsupportedOperationException(message)))
        .isEqualTo(NoWindow.MISSING_LIBRARIES);
  }

  @Test
  void aLinkErrorInsideAnotherFailureIsMissingLibraries() {
    Error inside = new UnsatisfiedLinkError("no glassgtk3 in java.library.path: /usr/lib");

    assertThat(because(new RuntimeException(inside))).isEqualTo(NoWindow.MISSING_LIBRARIES);
    assertThat(because(inside)).isEqualTo(NoWindow.MISSING_LIBRARIES);
    assertThat(NoWindow.MISSING_LIBRARIES.sentence())
        .contains("libgtk-3-0", "libgl1", "gtk3", "mesa-dri-drivers");
  }

  @Test
  void aJarOfAnotherSystemIsToldApartFromMissingLibraries() {
    Error failure = new UnsatisfiedLinkError("no glass in java.library.path: /usr/lib");

    assertThat(NoWindow.because(failure, false)).isEqualTo(NoWindow.OTHER_SYSTEM);
  }

  @Test
  void whatNobodyHasSeenYetIsNotGuessedAt() {
    assertThat(because(new IllegalStateException())).isEqualTo(NoWindow.UNKNOWN);
  }

  @ParameterizedTest
  @EnumSource
  void eachSaysThatTheSimulatorRunsAllTheSame(NoWindow reason) {
    assertThat(reason.sentence().toLowerCase(Locale.ROOT))
        .contains("so the simulator runs without", "window")
        .endsWith(".");
  }

  private static NoWindow because(Throwable failure) {
    return NoWindow.because(failure, true);
  }
}
