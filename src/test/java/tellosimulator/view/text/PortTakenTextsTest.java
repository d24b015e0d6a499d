package tellosimulator.view.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tellosimulator.network.PortTakenException.Obstacle;
import tellosimulator.translation.PhraseCatalog;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.pilot.DemoFlight;

/** The reasons why a drone stays off have texts in every place that switches drones on. */
class PortTakenTextsTest {

  @ParameterizedTest
  @EnumSource
  void eachObstacleHasWordsInTheLogAndForTheDemoFlight(Obstacle obstacle) {
    String word = obstacle.name().toLowerCase(Locale.ROOT).replace('_', '-');
    for (Locale locale : PhraseCatalog.OFFERED) {
      Language language = new Language(locale);
      assertThat(language.messages(LogQueue.class).now("port." + obstacle.name(), 8879, "10.0.0.1"))
          .containsAnyOf("8879", "10.0.0.1");
      assertThat(language.messages(DemoFlight.class).now("port-" + word, "8879", "10.0.0.1"))
          .containsAnyOf("8879", "10.0.0.1");
    }
  }
}
