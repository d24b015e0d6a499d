package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.app.AppFixture.change;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javafx.scene.control.Button;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.model.StartSettings;

/** The settings of a new run. */
class RestartFxTest {

  private static final StartSettings OTHER =
      new StartSettings(9, 0.5, new DroneOptics(Math.toRadians(70), Math.toRadians(5), 640));

  @RegisterExtension
  final AppFixture window = new AppFixture(() -> new Stage(StageStyle.UNDECORATED));

  private final FxRobot robot = window.robot();
  @TempDir private Path folder;

  @Test
  void afterAQuestionTheSameScenarioBeginsWithOtherNumbers() throws IOException {
    Path file = Files.writeString(folder.resolve("room.yaml"), "name: Mine\nseed: 4\n");
    change(() -> window.app().open(file));
    assertThat(shown("start-seed")).isEqualTo("4");

    change(() -> window.app().restart(OTHER));
    assertThat(shown("start-seed")).isEqualTo("4");
    robot.clickOn("#begin");

    waitUntil(() -> shown("start-seed").equals("9"));
    assertThat(shown("start-crash-speed")).isEqualTo("50");
    assertThat(shown("start-field-of-view")).isEqualTo("70");
    assertThat(shown("start-tilt")).isEqualTo("5");
    assertThat(window.stage().getTitle()).isEqualTo("room.yaml – Tello Simulator");
    assertThat(robot.lookup("#restart").queryAs(Button.class).isDisabled()).isTrue();
    assertThat(Files.readString(file)).isEqualTo("name: Mine\nseed: 4\n");
  }

  @Test
  void whoCancelsGoesOn() {
    change(() -> window.app().restart(OTHER));

    robot.clickOn("#go-on");

    assertThat(shown("start-seed")).isEqualTo("1");
  }

  @Test
  void aRoomThatCameFromNowhereStaysAsItIsNow() {
    robot.interact(() -> robot.lookup("#room-width-value").queryTextInputControl().setText("900"));
    robot.clickOn("#room-width-value").type(KeyCode.ENTER);

    change(() -> window.app().restart(OTHER));
    robot.clickOn("#begin");

    waitUntil(() -> shown("start-seed").equals("9"));
    waitUntil(() -> shown("room-width-value").equals("900"));
  }

  private String shown(String id) {
    return robot.lookup("#" + id).queryTextInputControl().getText();
  }
}
