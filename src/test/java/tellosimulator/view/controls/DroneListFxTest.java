package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.HBox;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.Control;
import tellosimulator.view.testing.StageExtension;

@ExtendWith(StageExtension.class)
class DroneListFxTest {

  /** The number of drones that fit into the default room. */
  private static final int DRONES = 40;

  private PanelWindow window;

  @Start
  void open(Stage stage) {
    window = PanelWindow.open(stage, DRONES, DroneList::new);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void rowsSayStateBatteryAndAddress(FxRobot robot) {
    window.carryOut(new Control.Power(2, true));
    window.carryOut(new Control.SetBattery(2, 42));
    int port = window.simulation().addresses(2).get(0).getPort();

    window.until(() -> row(robot, 2).equals(List.of("2", "standing", "42 %", "127.0.0.1:" + port)));
    assertThat(row(robot, 1)).startsWith("1", "off", "100 %");
    assertThat(window.text("#drones-heading")).isEqualTo("1 of 40 on");

    window.speak(Locale.GERMAN);
    assertThat(row(robot, 2)).startsWith("2", "steht");
  }

  @Test
  void onlyRowsThatAreSeenAreMade(FxRobot robot) {
    int rows = robot.lookup(".drone-row").queryAll().size();

    assertThat(rows).isBetween(5, 9);
  }

  @Test
  void aClickOrAnArrowKeyChoosesTheDrone(FxRobot robot) {
    robot.clickOn(rowNode(robot, 3));
    assertThat(window.context().simulation().selected().number()).isEqualTo(3);

    robot.type(KeyCode.DOWN);
    assertThat(window.context().simulation().selected().number()).isEqualTo(4);
  }

  @Test
  void aDroneChosenElsewhereIsMarkedAndInSight(FxRobot robot) {
    robot.interact(() -> window.context().simulation().selectNext(-1));

    assertThat(window.context().simulation().selected().number()).isEqualTo(DRONES);
    assertThat(
            robot.lookup("#drones").queryAs(ListView.class).getSelectionModel().getSelectedIndex())
        .isEqualTo(DRONES - 1);
    window.until(() -> robot.lookup(".drone-row").queryAll().stream().anyMatch(this::isLast));

    robot.interact(() -> window.context().simulation().selectNext(1));
    assertThat(window.context().simulation().selected().number()).isEqualTo(1);
  }

  private boolean isLast(Node row) {
    return words((HBox) row).get(0).equals(Integer.toString(DRONES));
  }

  @Test
  void allAreSwitchedOnAndOffAndPutBack(FxRobot robot) {
    robot.clickOn("#drones-on");
    assertThat(window.snapshot().drones())
        .allMatch(drone -> drone.state().phase() == FlightPhase.GROUNDED);
    window.until(() -> window.text("#drones-heading").equals("40 of 40 on"));

    robot.clickOn("#drones-off");
    assertThat(window.snapshot().drones())
        .allMatch(drone -> drone.state().phase() == FlightPhase.OFF);
  }

  private static HBox rowNode(FxRobot robot, int number) {
    return robot.lookup(".drone-row").queryAll().stream()
        .map(HBox.class::cast)
        .filter(row -> words(row).get(0).equals(Integer.toString(number)))
        .findFirst()
        .orElseThrow();
  }

  private static List<String> row(FxRobot robot, int number) {
    return words(rowNode(robot, number));
  }

  private static List<String> words(HBox row) {
    return row.lookupAll(".label").stream().map(Label.class::cast).map(Label::getText).toList();
  }
}
