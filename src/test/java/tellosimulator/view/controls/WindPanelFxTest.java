package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.view.testing.StageExtension;
import tellosimulator.world.Wind;

@ExtendWith(StageExtension.class)
class WindPanelFxTest {

  private PanelWindow window;

  @Start
  void open(Stage stage) {
    window = PanelWindow.open(stage, 1, WindPanel::new);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void itIsCalmAtFirst() {
    assertThat(window.snapshot().arena().wind()).isEqualTo(Wind.CALM);
    assertThat(window.typed("#wind-speed-value")).isEqualTo("0");
    assertThat(window.typed("#wind-gusts-value")).isEqualTo("0");
  }

  @Test
  void typedWindBlows() {
    window.enter("#wind-towards-value", "90");
    window.enter("#wind-speed-value", "150");
    window.enter("#wind-gusts-value", "40");

    window.until(() -> window.snapshot().arena().wind().gusts() > 0);
    Wind wind = window.snapshot().arena().wind();
    assertThat(wind.mean().x()).isCloseTo(0, within(1e-9));
    assertThat(wind.mean().y()).isCloseTo(1.5, within(1e-9)); // y is to the left
    assertThat(wind.gusts()).isCloseTo(0.4, within(1e-9));
  }

  @Test
  void theDirectionIsKeptWhileItIsCalm(FxRobot robot) {
    window.enter("#wind-towards-value", "-90");
    window.settle();
    robot.interact(() -> robot.lookup("#wind-speed").query().requestFocus());
    robot.type(KeyCode.RIGHT, 3);

    window.until(() -> window.snapshot().arena().wind().mean().norm() > 0.25);
    Vec3 mean = window.snapshot().arena().wind().mean();
    assertThat(mean.y()).isCloseTo(-0.3, within(1e-9)); // three steps of 10 cm/s
  }

  @Test
  void windFromElsewhereIsShown() {
    Wind wind = new Wind(new Vec3(-0.6, 0.6, 0), 0.25);
    window.carryOut(new Control.SetWind(wind));

    window.until(() -> window.typed("#wind-gusts-value").equals("25"));
    assertThat(window.typed("#wind-towards-value")).isEqualTo("135");
    assertThat(window.typed("#wind-speed-value")).isEqualTo("84.9"); // 60 times the root of 2
    assertThat(window.text("#wind-now")).isEqualTo("85 cm/s");
  }

  @Test
  void aGaleIsRefusedWithASentence() {
    window.enter("#wind-speed-value", "2001");

    assertThat(window.sentence("#wind-speed-value-error")).isEqualTo("Must be from 0 to 2000.");
    assertThat(window.snapshot().arena().wind()).isEqualTo(Wind.CALM);
  }
}
