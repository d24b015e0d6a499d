package tellosimulator.view.pilot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.testfx.util.WaitForAsyncUtils.waitFor;
import static tellosimulator.view.testing.WindowFixture.settle;

import atlantafx.base.theme.PrimerLight;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javafx.application.Application;
import javafx.geometry.Bounds;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.testing.StageExtension;
import tellosimulator.world.Room;

@ExtendWith(StageExtension.class)
class PilotControlsFxTest {

  private FlownWindow window;
  private PilotControls controls;
  private Stage stage;

  @Start
  void start(Stage newStage) {
    stage = newStage;
    Application.setUserAgentStylesheet(new PrimerLight().getUserAgentStylesheet());
    window =
        new FlownWindow(
            SimConfig.DEFAULT
                .withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT))
                .withTimeFactor(new TimeFactor(10)));
    controls = new PilotControls(window.context());
    TextField field = new TextField();
    field.setId("field");
    Region above = new Region();
    VBox.setVgrow(above, Priority.ALWAYS);
    Scene scene = new Scene(new VBox(field, above, controls), 540, 400);
    controls.install(scene);
    stage.setScene(scene);
    stage.show();
    controls.lookup("#demo-flight").requestFocus();
    window.context().ticker().start();
  }

  @AfterEach
  void close(FxRobot robot) {
    robot.interact(
        () -> {
          window.context().ticker().stop();
          controls.close();
          stage.hide();
        });
    window.close();
  }

  @Test
  void keysFlyUnlessAControlWasReachedByKeyboard(FxRobot robot) throws TimeoutException {
    window.carryOut(new Control.Power(1, true));
    robot.clickOn("#keyboard-flight");
    robot.press(KeyCode.W);
    await(() -> window.commands().contains("rc 0 60 0 0"));
    robot.release(KeyCode.W);
    await(() -> window.commands().contains("rc 0 0 0 0"));

    robot.type(KeyCode.TAB).press(KeyCode.S);
    assertThat(controls.keyboard().pressed()).isEmpty();
    robot.release(KeyCode.S);
  }

  @Test
  void theDemoButtonSwitchesOnFliesAndStops(FxRobot robot) throws TimeoutException {
    robot.clickOn("#demo-flight");
    await(() -> window.commands().contains("up 90"));
    assertThat(button(robot, "#demo-flight").getText()).isEqualTo("Stop");
    assertThat(button(robot, "#pilot-takeoff").isDisabled()).isTrue();
    assertThat(robot.lookup("#keyboard-flight").queryAs(ToggleButton.class).isDisabled()).isTrue();
    assertThat(label(robot, "#pilot-command").getText()).matches("\\d+ / 15  .+");

    robot.clickOn("#demo-flight");

    await(() -> !controls.demo().runningProperty().get());
    assertThat(window.phase()).isEqualTo(FlightPhase.GROUNDED);
    assertThat(button(robot, "#demo-flight").getText()).isEqualTo("Demo flight");
    assertThat(label(robot, "#pilot-command").getParent().isVisible()).isFalse();
  }

  @Test
  void buttonsTakeOffLandAndStopTheMotors(FxRobot robot) throws TimeoutException {
    assertThat(button(robot, "#pilot-land").isDisabled()).isTrue();
    assertThat(button(robot, "#pilot-emergency").isDisabled()).isTrue();

    robot.clickOn("#pilot-takeoff");
    await(() -> window.phase() == FlightPhase.FLYING && !button(robot, "#pilot-land").isDisabled());
    window.carryOut(new Control.SetTimeFactor(TimeFactor.MAX));
    await(() -> window.context().simulation().selected().zCm() > 29);
    robot.clickOn("#pilot-land");
    await(() -> window.phase() == FlightPhase.GROUNDED);

    robot.clickOn("#pilot-takeoff");
    await(() -> !button(robot, "#pilot-emergency").isDisabled());
    robot.clickOn("#pilot-emergency");
    await(() -> window.commands().contains("emergency"));
    await(() -> window.phase() == FlightPhase.GROUNDED);
  }

  @Test
  void aRefusalIsShownAndFollowsTheLanguage(FxRobot robot) throws TimeoutException {
    window.carryOut(new Control.SetBattery(1, 8));

    robot.clickOn("#pilot-takeoff");

    await(() -> label(robot, "#pilot-problem").isVisible());
    assertThat(label(robot, "#pilot-problem").getText())
        .isEqualTo("The drone answered “error” to “takeoff”; the log says why.");
    robot.interact(() -> window.context().language().localeProperty().set(Locale.GERMAN));
    assertThat(label(robot, "#pilot-problem").getText()).startsWith("Die Drohne hat auf „takeoff“");
    assertThat(button(robot, "#pilot-takeoff").getText()).isEqualTo("Abheben");
  }

  @Test
  void aRefusalIsGoneWhenTheDemoBegins(FxRobot robot) throws TimeoutException {
    window.carryOut(new Control.SetBattery(1, 8));
    robot.clickOn("#pilot-takeoff");
    await(() -> label(robot, "#pilot-problem").isVisible());
    window.carryOut(new Control.SetBattery(1, 100));

    robot.clickOn("#demo-flight");

    await(() -> window.phase() == FlightPhase.FLYING);
    assertThat(label(robot, "#pilot-problem").isVisible()).isFalse();
  }

  @Test
  void theDemosProblemIsGoneAfterATakeoffThatSucceeds(FxRobot robot) throws TimeoutException {
    window.carryOut(new Control.SetBattery(1, 8));
    robot.clickOn("#demo-flight");
    await(() -> label(robot, "#pilot-problem").isVisible());
    await(() -> !controls.demo().runningProperty().get());
    window.carryOut(new Control.SetBattery(1, 100));

    robot.clickOn("#pilot-takeoff");

    await(() -> window.phase() == FlightPhase.FLYING);
    assertThat(label(robot, "#pilot-problem").isVisible()).isFalse();
  }

  @Test
  void heldKeysMoveTheSticksAndReleasedOnesCenterThem(FxRobot robot) throws TimeoutException {
    flyByKeyboard(robot);

    robot.press(KeyCode.W);
    await(() -> lastCommand().equals("rc 0 60 0 0"));
    assertThat(lit(robot, SteeringKey.FORWARD)).isTrue();
    robot.press(KeyCode.RIGHT);
    await(() -> lastCommand().equals("rc 0 60 0 60"));
    robot.press(KeyCode.SHIFT);
    await(() -> lastCommand().equals("rc 0 100 0 100"));
    robot.release(KeyCode.SHIFT).release(KeyCode.W).press(KeyCode.A).press(KeyCode.UP);
    await(() -> lastCommand().equals("rc -60 0 60 60"));
    robot.release(KeyCode.A).release(KeyCode.UP).release(KeyCode.RIGHT);
    await(() -> lastCommand().equals("rc 0 0 0 0"));
    assertThat(lit(robot, SteeringKey.FORWARD)).isFalse();
  }

  @Test
  void spaceTakesOffAndLandsAndOtherKeysActOnce(FxRobot robot) throws TimeoutException {
    flyByKeyboard(robot);

    robot.type(KeyCode.F);
    await(() -> window.answered("flip f")); // in a flip it is so high that it would crash
    robot.type(KeyCode.X);
    await(() -> window.commands().contains("emergency"));
    await(
        () ->
            window.phase() == FlightPhase.GROUNDED && controls.lookup("#pilot-land").isDisabled());
    robot.type(KeyCode.SPACE);
    await(() -> window.phase() == FlightPhase.FLYING || window.phase() == FlightPhase.TAKING_OFF);

    assertThat(window.commands().stream().filter("takeoff"::equals)).hasSize(2);
    assertThat(window.commands().stream().filter("flip f"::equals)).hasSize(1);
    assertThat(controls.demo().runningProperty().get()).isFalse();
  }

  @Test
  void theDroneStaysInTheAirWhileKeysMayFlyIt(FxRobot robot) throws TimeoutException {
    flyByKeyboard(robot);
    double from = window.context().simulation().secondsProperty().get();

    await(() -> window.context().simulation().secondsProperty().get() > from + 20);

    assertThat(window.phase()).isEqualTo(FlightPhase.FLYING);
  }

  @Test
  void losingTheFocusCentersTheSticks(FxRobot robot) throws TimeoutException {
    flyByKeyboard(robot);
    robot.press(KeyCode.W);
    await(() -> lastCommand().equals("rc 0 60 0 0"));

    robot.interact(() -> robot.lookup("#field").query().requestFocus());

    await(() -> lastCommand().equals("rc 0 0 0 0"));
    robot.release(KeyCode.W);
  }

  @Test
  void switchingOffCentersTheSticks(FxRobot robot) throws TimeoutException {
    flyByKeyboard(robot);
    robot.press(KeyCode.D);
    await(() -> lastCommand().equals("rc 60 0 0 0"));

    robot.interact(() -> controls.keyboard().activeProperty().set(false));

    await(() -> lastCommand().equals("rc 0 0 0 0"));
    robot.release(KeyCode.D);
  }

  @Test
  void choosingAnotherDroneCentersTheSticksOfTheOneThatFlew(FxRobot robot) throws TimeoutException {
    flyByKeyboard(robot);
    robot.press(KeyCode.D);
    await(() -> lastCommand().equals("rc 60 0 0 0"));
    FxSimulation simulation = window.context().simulation();

    robot.interact(() -> simulation.selectedProperty().set(simulation.drones().get(1)));

    await(() -> lastCommand().equals("rc 0 0 0 0"));
    assertThat(controls.keyboard().activeProperty().get()).isFalse();
    robot.release(KeyCode.D);
  }

  @Test
  void textFieldsKeepTheirKeys(FxRobot robot) throws TimeoutException {
    flyByKeyboard(robot);
    int before = window.commands().size();
    robot.interact(() -> robot.lookup("#field").query().requestFocus());

    robot.type(KeyCode.W, KeyCode.F, KeyCode.X);
    settle();

    assertThat(robot.lookup("#field").queryAs(TextField.class).getText()).isEqualTo("wfx");
    assertThat(window.commands().subList(before, window.commands().size()))
        .allMatch("rc 0 0 0 0"::equals);
  }

  @Test
  void noButtonMovesWhenSomethingAppearsAboveIt(FxRobot robot) {
    Bounds before = onScreen(robot);

    robot.clickOn("#keyboard-flight");

    assertThat(robot.lookup("#key-hint").query().isVisible()).isTrue();
    assertThat(onScreen(robot)).isEqualTo(before);
  }

  private static Bounds onScreen(FxRobot robot) {
    settle();
    Button emergency = button(robot, "#pilot-emergency");
    return emergency.localToScreen(emergency.getBoundsInLocal());
  }

  @Test
  void keysDoNothingUnlessSwitchedOn(FxRobot robot) {
    robot.type(KeyCode.W, KeyCode.X);
    settle();

    assertThat(controls.keyboard().pressed()).isEmpty();
    assertThat(window.commands()).isEmpty();
    assertThat(robot.lookup("#key-hint").query().isVisible()).isFalse();
  }

  private void flyByKeyboard(FxRobot robot) throws TimeoutException {
    robot.clickOn("#keyboard-flight");
    assertThat(robot.lookup("#key-hint").query().isVisible()).isTrue();
    robot.type(KeyCode.SPACE);
    await(() -> window.phase() == FlightPhase.FLYING);
  }

  private String lastCommand() {
    List<String> commands = window.commands();
    return commands.get(commands.size() - 1);
  }

  private static boolean lit(FxRobot robot, SteeringKey key) {
    return robot.lookup("#cap-" + key.textKey()).query().getPseudoClassStates().stream()
        .anyMatch(state -> state.getPseudoClassName().equals("lit"));
  }

  private static Button button(FxRobot robot, String id) {
    return robot.lookup(id).queryButton();
  }

  private static Label label(FxRobot robot, String id) {
    return robot.lookup(id).queryAs(Label.class);
  }

  private static void await(Callable<Boolean> reached) throws TimeoutException {
    waitFor(60, TimeUnit.SECONDS, reached);
    settle();
  }
}
