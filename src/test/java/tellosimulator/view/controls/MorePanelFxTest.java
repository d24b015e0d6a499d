package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javafx.scene.control.Button;
import javafx.scene.control.ToggleButton;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.sim.Control;
import tellosimulator.view.testing.StageExtension;
import tellosimulator.world.Surface;
import tellosimulator.world.Walls;

@ExtendWith(StageExtension.class)
class MorePanelFxTest {

  @TempDir private Path folder;
  private PanelWindow window;
  private MorePanel panel;

  @Start
  void open(Stage stage) {
    window =
        PanelWindow.open(
            stage,
            2,
            context -> {
              panel = new MorePanel(context);
              return panel;
            });
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void itIsFoldedAtFirst(FxRobot robot) {
    assertThat(robot.lookup("#restart").query().getParent().getParent().isVisible()).isFalse();

    robot.clickOn("#card-more");

    assertThat(robot.lookup("#restart").query().getParent().getParent().isVisible()).isTrue();
  }

  @Test
  void theBatteryOfTheSelectedDroneIsSetAndShown(FxRobot robot) {
    robot.clickOn("#card-more");
    assertThat(window.typed("#battery-level-value")).isEqualTo("100");

    window.enter("#battery-level-value", "35");
    window.until(() -> Math.rint(window.drone(1).state().energy().battery().percent()) == 35);
    assertThat(window.drone(2).state().energy().battery().percent()).isEqualTo(100);

    window.carryOut(new Control.SetBattery(1, 80));
    window.until(() -> window.typed("#battery-level-value").equals("80"));
  }

  @Test
  void wallsAreChangedAndAScenarioThatChangesThemIsShown(FxRobot robot) {
    robot.clickOn("#card-more").clickOn("#walls-plain");

    window.until(() -> window.snapshot().decor().walls() == Walls.PLAIN);
    window.until(() -> robot.lookup("#walls-plain").queryAs(ToggleButton.class).isSelected());
  }

  @Test
  void aPictureHangsOnTheFrontWallUntilItIsTakenDown(FxRobot robot) throws IOException {
    Path picture = Files.copy(Path.of("docs/images/drone.png"), folder.resolve("drone.png"));
    robot.clickOn("#card-more");
    assertThat(robot.lookup("#poster-take-down").queryAs(Button.class).isDisabled()).isTrue();

    robot.interact(() -> panel.hang(picture.toString()));
    window.until(() -> window.snapshot().decor().posters().size() == 1);
    assertThat(window.snapshot().decor().posters().get(0).surface()).isEqualTo(Surface.FRONT_WALL);

    window.until(() -> !robot.lookup("#poster-take-down").queryAs(Button.class).isDisabled());
    robot.clickOn("#poster-take-down");
    window.until(() -> window.snapshot().decor().posters().isEmpty());
  }

  @Test
  void whatIsNoPictureIsASentence(FxRobot robot) throws IOException {
    Path text = Files.writeString(folder.resolve("words.png"), "words");
    robot.clickOn("#card-more");

    robot.interact(() -> panel.hang(text.toString()));

    assertThat(window.text("#poster-error")).contains("words.png is no picture");
    assertThat(window.snapshot().decor().posters()).isEmpty();
  }

  @Test
  void onlyOtherNumbersCanBeBegunWith(FxRobot robot) {
    robot.clickOn("#card-more");
    Button begin = robot.lookup("#restart").queryAs(Button.class);
    assertThat(begin.isDisabled()).isTrue();

    window.enter("#start-seed", "7.5");
    assertThat(window.text("#start-seed-error")).isEqualTo("A seed is a whole number.");
    assertThat(begin.isDisabled()).isTrue();

    window.enter("#start-seed", "7");
    assertThat(begin.isDisabled()).isFalse();
  }
}
