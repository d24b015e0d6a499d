package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.OptionalLong;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.web.ScenarioHost;
import tellosimulator.web.WebSubject;

/** What the teacher's board sees of the window, and does with it. */
class BoardWindowFxTest {

  @RegisterExtension
  final AppFixture window = new AppFixture(() -> new Stage(StageStyle.UNDECORATED));

  @TempDir private Path folder;

  @Test
  void anotherScenarioIsAnotherSubject() throws IOException {
    ScenarioHost host = window.app().host();
    WebSubject first = host.current();
    assertThat(host.current()).isSameAs(first);
    Path file = Files.writeString(folder.resolve("room.yaml"), "name: Mine\nseed: 4\n");

    change(() -> window.app().open(file));

    WebSubject second = host.current();
    assertThat(second.number()).isEqualTo(2);
    assertThat(second.opened().scenario().description().name().english()).isEqualTo("Mine");
  }

  @Test
  void theBoardOpensTheScenarioAgain() throws Exception {
    ScenarioHost host = window.app().host();
    WebSubject first = host.current();

    host.open(first.opened(), OptionalLong.of(5));

    waitUntil(() -> host.current().number() == 2);
  }

  @Test
  void theBoardSwitchesDronesOn() {
    ScenarioHost host = window.app().host();

    host.current().requests().result(Map.of("do", "power", "drone", 1L, "on", true));

    assertThat(host.current().simulation().snapshot().drones().get(0).state().phase().name())
        .isEqualTo("GROUNDED");
  }
}
