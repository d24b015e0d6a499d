package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

class MessagesOfControlsTest {

  private final Messages german = new Language(Locale.GERMAN).messages(FlightPanel.class);

  @Test
  void bothLanguagesSayTheSame() {
    assertThat(keys(Locale.GERMAN)).isEqualTo(keys(Locale.ROOT));
  }

  @ParameterizedTest
  @EnumSource
  void everyPhaseHasWords(FlightPhase phase) {
    assertThat(german.now(FlightPanel.keyOf(phase))).isNotBlank();
  }

  @ParameterizedTest
  @EnumSource
  void everyProfileHasAName(Profile profile) {
    assertThat(german.now("profile." + profile.option())).isNotBlank();
    assertThat(german.now("profile." + profile.option() + ".hint")).isNotBlank();
  }

  @ParameterizedTest
  @EnumSource
  void everyBehaviorHasAName(Behavior behavior) {
    assertThat(german.now("behaviour." + behavior.option())).isNotBlank();
    assertThat(german.now("behaviour." + behavior.option() + ".hint")).isNotBlank();
  }

  private static Set<String> keys(Locale locale) {
    return ResourceBundle.getBundle(
            "tellosimulator.view.controls.messages",
            locale,
            ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES))
        .keySet();
  }
}
