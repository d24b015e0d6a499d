package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import javafx.scene.control.Label;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.math.Pose;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/** The view for a class, and what makes the window ready for the next group. */
class ProjectorViewFxTest {

  private final FxRobot robot = new FxRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.open(SimConfig.DEFAULT, folder.resolve("settings"));
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void thereIsNothingButTheSceneAndLargeTypeUntilEscape() {
    project();
    assertThat(window.shows("projector")).isTrue();
    assertThat(window.shows("scene-3d")).isTrue();
    for (String part : new String[] {"window-bar", "simulator-controls", "log", "demo-flight"}) {
      assertThat(window.shows(part)).as(part).isFalse();
    }
    assertThat(onFxThread(() -> window.find("projector-clock", Label.class).getFont().getSize()))
        .isGreaterThan(20);

    robot.type(KeyCode.ESCAPE);
    assertThat(window.shows("projector")).isFalse();
    assertThat(window.shows("window-bar")).isTrue();
    assertThat(window.shows("demo-flight")).isTrue();

    project();
    project();
    assertThat(window.shows("projector")).isFalse();
    assertThat(window.state().fullScreenProperty().get()).as("as before").isFalse();
  }

  @Test
  void theLastCommandAndItsOutcomeAreToBeRead() {
    window.switchOn();
    project();

    window.fly("command", "takeoff");
    waitUntil(() -> window.text("projector-command").equals("takeoff"));
    waitUntil(() -> window.text("projector-outcome").equals("ok"));
    window.tell(1, "up 9999");
    String refusal = window.reply(1);
    waitUntil(() -> window.text("projector-command").equals("up 9999"));
    waitUntil(() -> window.text("projector-outcome").equals(refusal));
  }

  @Test
  void theNextGroupFindsEverythingAsItWasAtFirst() {
    Pose start = drone().state().motion().pose();
    window.switchOn();
    window.fly("command", "takeoff");
    window.carryOut(new Control.SetBattery(1, 40));
    waitUntil(() -> !window.log().isEmpty());

    robot.press(KeyCode.CONTROL, KeyCode.SHIFT).type(KeyCode.N);
    robot.release(KeyCode.SHIFT, KeyCode.CONTROL);

    assertThat(drone().state().motion().pose()).isEqualTo(start);
    assertThat(drone().state().energy().battery().percent()).isGreaterThan(99);
    waitUntil(() -> window.log().isEmpty());
  }

  private DroneSnapshot drone() {
    return window.snapshot().drones().get(0);
  }

  private void project() {
    robot.press(KeyCode.SHIFT).type(KeyCode.F11).release(KeyCode.SHIFT);
  }
}
