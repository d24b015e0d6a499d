package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import javafx.scene.Node;
import javafx.scene.control.ListCell;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.HBox;
import javafx.scene.shape.Circle;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.Control;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.testing.StageExtension;

@ExtendWith(StageExtension.class)
class DroneComboBoxFxTest {

  private PanelWindow window;

  @Start
  void open(Stage stage) {
    window = PanelWindow.open(stage, 3, DroneComboBoxFxTest::panels);
  }

  private static HBox panels(ViewContext context) {
    return new HBox(new SimulatorControls(context), new NetworkControls(context));
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void anotherDroneIsShownAndControlled(FxRobot robot) {
    window.carryOut(new Control.SetBattery(2, 42));
    assertThat(window.text("#y")).isEqualTo("60"); // drones stand in a row, 60 cm apart

    choose(robot, KeyCode.DOWN);

    assertThat(window.context().simulation().selected().number()).isEqualTo(2);
    window.until(() -> window.text("#y").equals("0"));
    window.until(() -> entry(robot).getText().equals("Drone 2 · off · 42 %"));
    assertThat(((Circle) entry(robot).getGraphic()).getFill())
        .isEqualTo(DroneColors.of(window.context().simulation().drones().get(1)));

    robot.clickOn("#power");
    window.until(() -> window.drone(2).state().phase() == FlightPhase.GROUNDED);
    window.until(() -> window.drone(1).state().phase() == FlightPhase.OFF);
    window.until(() -> entry(robot).getText().equals("Drone 2 · standing · 42 %"));

    robot.clickOn("#battery-charge");
    assertThat(window.drone(2).state().energy().battery().percent()).isEqualTo(100);

    window.speak(Locale.GERMAN);
    assertThat(entry(robot).getText()).isEqualTo("Drohne 2 · steht · 100 %");
  }

  @Test
  void whatWasTypedForOneDroneIsNotMeantForAnother(FxRobot robot) {
    window.enter("#start-x-value", "nonsense");

    choose(robot, KeyCode.DOWN);
    window.settle();

    assertThat(window.typed("#start-x-value")).isEqualTo("0");
    assertThat(window.sentence("#start-x-value-error")).isEmpty();
  }

  @Test
  void theSwitchShowsTheSelectedDronesPower(FxRobot robot) {
    robot.clickOn("#power");
    window.until(() -> window.text("#power").equals("Stop Drone"));

    choose(robot, KeyCode.DOWN);
    window.until(() -> window.text("#power").equals("Start Drone"));
    assertThat(robot.lookup("#command-port").query().isDisabled()).isFalse();

    choose(robot, KeyCode.UP);
    window.until(() -> window.text("#power").equals("Stop Drone"));
    assertThat(robot.lookup("#command-port").query().isDisabled()).isTrue();
  }

  private static void choose(FxRobot robot, KeyCode direction) {
    robot.interact(() -> robot.lookup("#drone-choice").query().requestFocus());
    robot.type(direction);
  }

  private static ListCell<?> entry(FxRobot robot) {
    Node cell = robot.lookup("#drone-choice > .list-cell").query();
    return (ListCell<?>) cell;
  }
}
