package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import javafx.scene.AccessibleAttribute;
import javafx.scene.control.Slider;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.Clipboard;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.Control;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.testing.StageExtension;
import tellosimulator.world.Decor;
import tellosimulator.world.Room;

@ExtendWith(StageExtension.class)
class SimulatorControlsFxTest {

  private PanelWindow window;
  private SimulatorControls controls;

  @Start
  void open(Stage stage) {
    window =
        PanelWindow.open(
            stage,
            1,
            context -> {
              controls = new SimulatorControls(context);
              return controls;
            });
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void numbersInstrumentsAndWordsFollowTheFlight(FxRobot robot) throws IOException {
    assertThat(window.text("#phase")).isEqualTo("off");
    window.carryOut(new Control.Power(1, true));
    window.carryOut(new Control.SetTimeFactor(TimeFactor.MAX));

    assertThat(window.fly("command", "takeoff", "up 70", "cw 90", "forward 100")).isEqualTo("ok");

    window.until(() -> window.text("#phase").equals("flying"));
    window.settle();
    assertThat(window.text("#z")).isEqualTo("100");
    assertThat(window.text("#x")).isEqualTo("0");
    int y = Integer.parseInt(window.text("#y"));
    assertThat(y).isBetween(-102, -98); // it faced right, where y is negative
    assertThat(window.text("#yaw")).isEqualTo("90");
    assertThat(Integer.parseInt(window.text("#speed"))).isBetween(0, 5);
    assertThat(accessible(robot, "#compass")).isEqualTo("Heading: yaw 90 degrees");
    assertThat(accessible(robot, "#height-bar")).isEqualTo("Height: 100 of 300 centimetres");
    assertThat(accessible(robot, "#attitude")).contains("pitch 0 degrees");
  }

  @Test
  void theFirstProgramIsThereUntilSomethingHasFlownAndThenTheCharts(FxRobot robot)
      throws IOException {
    window.carryOut(new Control.Power(1, true));
    window.until(() -> isOpen(robot, "#card-program"));
    window.until(() -> window.text("#panel-program").contains("host = \"127.0.0.1\""));
    assertThat(isOpen(robot, "#card-charts")).isFalse();
    window.carryOut(new Control.SetTimeFactor(TimeFactor.MAX));

    assertThat(window.fly("command", "takeoff")).isEqualTo("ok");

    window.until(() -> isOpen(robot, "#card-charts") && !isOpen(robot, "#card-program"));
    robot.clickOn("#panel-copy-program");
    String[] copied = new String[1];
    robot.interact(() -> copied[0] = Clipboard.getSystemClipboard().getString());
    assertThat(copied[0]).as("also while it is folded").contains("tello.takeoff()");
    robot.clickOn("#card-program");
    assertThat(isOpen(robot, "#card-program")).as("whoever still wants it").isTrue();
  }

  private static boolean isOpen(FxRobot robot, String card) {
    return robot.lookup(card).queryAs(ToggleButton.class).isSelected();
  }

  @Test
  void nothingIsEverMinusZero() {
    window.carryOut(new Control.SetStart(1, new Vec3(-0.002, -0.5, 0)));

    window.until(() -> window.text("#y").equals("-50"));
    window.until(() -> window.text("#x").equals("0"));
    window.until(() -> window.typed("#start-x-value").equals("-0.2"));

    window.carryOut(new Control.SetStart(1, new Vec3(-0.0002, 0.5, 0)));
    window.until(() -> window.text("#y").equals("50"));
    window.until(() -> window.typed("#start-x-value").equals("0"));
  }

  @Test
  void resetPutsTheDroneBack(FxRobot robot) throws IOException {
    window.carryOut(new Control.Power(1, true));
    window.carryOut(new Control.SetTimeFactor(TimeFactor.MAX));
    window.fly("command", "takeoff");
    assertThat(window.drone(1).state().motion().position().z()).isGreaterThan(0.2);

    robot.clickOn("#reset");

    window.until(() -> window.drone(1).state().phase() == FlightPhase.GROUNDED);
    assertThat(window.drone(1).state().motion().position()).isEqualTo(Vec3.ZERO);
    window.until(() -> window.text("#z").equals("0"));
  }

  @Test
  void cameraSwitchTurnsTheProperty(FxRobot robot) {
    assertThat(window.text("#camera-switch")).isEqualTo("Drone camera");

    robot.clickOn("#camera-switch");
    assertThat(controls.droneCameraProperty().get()).isTrue();
    assertThat(window.text("#camera-switch")).isEqualTo("Room camera");

    robot.interact(() -> controls.droneCameraProperty().set(false));
    assertThat(robot.lookup("#camera-switch").queryAs(ToggleButton.class).isSelected()).isFalse();
  }

  @Test
  void batteryIsChargedAndItsGaugeShowsIt(FxRobot robot) {
    window.carryOut(new Control.SetBattery(1, 15));
    window.until(() -> accessible(robot, "#battery").equals("Battery: 15 percent"));

    robot.clickOn("#battery-charge");

    window.until(() -> window.drone(1).state().energy().battery().percent() == 100);
    window.until(() -> accessible(robot, "#battery").equals("Battery: 100 percent"));
  }

  @Test
  void arrowKeysChangeTheRoom(FxRobot robot) {
    robot.interact(() -> robot.lookup("#room-width").query().requestFocus());
    robot.type(KeyCode.RIGHT, 3).type(KeyCode.LEFT);
    window.until(() -> window.snapshot().room().width() == 5.2);

    robot.clickOn("#room-height-value").type(KeyCode.DOWN, 5);
    window.until(() -> window.snapshot().room().height() == 2.5);
    assertThat(window.snapshot().room()).isEqualTo(new Room(5.2, 5, 2.5));
    assertThat(window.typed("#room-width-value")).isEqualTo("520");
  }

  @Test
  void aChangeGoesToTheSimulationWithoutWaitingForAPulse(FxRobot robot) {
    window.settle();
    robot.interact(
        () -> {
          robot.lookup("#room-width").queryAs(Slider.class).setValue(700);
          assertThat(window.context().actions().pending()).isTrue();
        });
    window.until(() -> window.snapshot().room().width() == 7);
  }

  @Test
  void theMouseDragsTheRoom(FxRobot robot) {
    robot.drag("#room-depth .thumb").dropBy(30, 0);

    window.until(() -> window.snapshot().room().depth() > 6);
    window.settle();
    double depthCm = window.snapshot().room().depth() * 100;
    assertThat(depthCm % 10).isZero();
    assertThat(Double.parseDouble(window.typed("#room-depth-value"))).isEqualTo(depthCm);
    assertThat(robot.lookup("#room-depth").queryAs(Slider.class).getValue()).isEqualTo(depthCm);
  }

  @Test
  void aFieldTakesMoreThanItsSliderReaches() {
    window.enter("#room-width-value", "20000");

    window.until(() -> window.snapshot().room().width() == 200);
    window.settle();
    assertThat(window.typed("#room-width-value")).isEqualTo("20000");
    assertThat(window.snapshot().room().width()).isEqualTo(200);
  }

  @Test
  void commaAndDotAreBothTaken() {
    window.enter("#room-width-value", "612,5");
    window.until(() -> window.snapshot().room().width() == 6.125);

    window.enter("#room-width-value", "712.5");
    window.until(() -> window.snapshot().room().width() == 7.125);
  }

  @Test
  void aWrongNumberIsMarkedAndSentNowhere(FxRobot robot) {
    Room before = window.snapshot().room();
    for (String wrong : List.of("abc", " ", "NaN", "1e9", "1000000000", "99.9", "-300", "20001")) {
      window.enter("#room-width-value", wrong);

      assertThat(window.sentence("#room-width-value-error")).as(wrong).isNotEmpty();
      assertThat(marked(robot, "#room-width-value")).as(wrong).isTrue();
      window.settle();
      assertThat(window.snapshot().room()).as(wrong).isEqualTo(before);
      assertThat(window.typed("#room-width-value")).isEqualTo(wrong);

      robot.type(KeyCode.ESCAPE);

      assertThat(window.typed("#room-width-value")).as(wrong).isEqualTo("500");
      assertThat(window.sentence("#room-width-value-error")).as(wrong).isEmpty();
      assertThat(marked(robot, "#room-width-value")).as(wrong).isFalse();
    }
  }

  @Test
  void aWrongNumberIsSaidInTheLanguageOfTheWindow() {
    window.enter("#room-width-value", "20001");
    assertThat(window.sentence("#room-width-value-error")).isEqualTo("Must be from 100 to 20000.");

    window.speak(Locale.GERMAN);

    assertThat(window.sentence("#room-width-value-error")).isEqualTo("Nur von 100 bis 20000.");
    assertThat(window.text("#reset")).isEqualTo("Drohne zurück");
    assertThat(window.text("#phase")).isEqualTo("aus");
  }

  @Test
  void theGridGoesThroughTheSimulation(FxRobot robot) {
    robot.interact(() -> robot.lookup("#grid-size").query().requestFocus());
    robot.type(KeyCode.RIGHT, 2);

    window.until(() -> window.context().simulation().decorProperty().get().grid() == 0.5);

    robot.interact(() -> window.carryOut(new Control.Decorate(Decor.DEFAULT.withGrid(1))));
    window.until(() -> window.typed("#grid-size-value").equals("100"));
  }

  @Test
  void startStaysInTheRoomAndFollowsIt(FxRobot robot) {
    window.enter("#start-x-value", "241.4"); // 250 cm less the drone's radius of 8.7 cm
    assertThat(window.sentence("#start-x-value-error")).isEqualTo("Must be from -241.3 to 241.3.");

    window.enter("#start-x-value", "241.3");
    window.until(() -> near(window.drone(1).start().position().x(), 2.413));

    window.enter("#room-depth-value", "300");
    window.until(() -> near(window.drone(1).start().position().x(), 1.413));
    window.until(() -> window.typed("#start-x-value").equals("141.3"));

    robot.interact(() -> robot.lookup("#start-y").query().requestFocus());
    robot.type(KeyCode.LEFT);
    window.until(() -> near(window.drone(1).start().position().y(), -0.1));
    assertThat(window.drone(1).state().motion().position().y()).isEqualTo(-0.1);
  }

  @Test
  void whatIsChangedElsewhereIsShownAndNotSentBack() {
    window.carryOut(new Control.SetRoom(new Room(3.333, 12, 2)));

    window.until(() -> window.typed("#room-width-value").equals("333.3"));
    window.settle();
    assertThat(window.snapshot().room()).isEqualTo(new Room(3.333, 12, 2));

    window.enter("#room-height-value", "250");
    window.until(() -> window.snapshot().room().height() == 2.5);
    assertThat(window.snapshot().room()).isEqualTo(new Room(3.333, 12, 2.5));
  }

  private static boolean near(double value, double wanted) {
    return Math.abs(value - wanted) < 1e-9;
  }

  private static boolean marked(FxRobot robot, String id) {
    return robot.lookup(id).query().getPseudoClassStates().stream()
        .anyMatch(state -> state.getPseudoClassName().equals("danger"));
  }

  private static String accessible(FxRobot robot, String id) {
    return (String) robot.lookup(id).query().queryAccessibleAttribute(AccessibleAttribute.TEXT);
  }
}
