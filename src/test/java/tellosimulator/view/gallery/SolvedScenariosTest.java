package tellosimulator.view.gallery;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.testing.CapturedLog;
import tellosimulator.view.settings.Settings;

class SolvedScenariosTest {

  @TempDir private Path folder;

  @Test
  void whatWasSolvedIsRememberedAtTheNextStart() {
    Path file = folder.resolve("settings");
    Settings settings = Settings.load(file);
    SolvedScenarios solved = SolvedScenarios.remembered(settings);
    assertThat(solved.contains("slalom")).isFalse();
    solved.add("slalom");
    solved.add("wind");
    solved.add("slalom");
    settings.save();

    SolvedScenarios later = SolvedScenarios.remembered(Settings.load(file));
    assertThat(later.contains("slalom")).isTrue();
    assertThat(later.contains("wind")).isTrue();
    assertThat(later.contains("gate-race")).isFalse();
  }

  @Test
  void namesThatTheProgramDoesNotHaveAreRefused() throws Exception {
    Path file = folder.resolve("settings");
    Files.writeString(file, "solved-scenarios=slalom,nonsense\n");
    try (CapturedLog log = CapturedLog.of(Settings.class)) {
      SolvedScenarios solved = SolvedScenarios.remembered(Settings.load(file));

      assertThat(solved.contains("slalom")).isFalse();
      assertThat(log.next()).contains("names of scenarios");
    }
  }
}
