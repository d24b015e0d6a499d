package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import javafx.scene.control.ChoiceBox;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.fault.Fault;
import tellosimulator.fault.LinkPreset;
import tellosimulator.sim.Control;
import tellosimulator.view.testing.StageExtension;

@ExtendWith(StageExtension.class)
class FaultPanelFxTest {

  private PanelWindow window;

  @Start
  void open(Stage stage) {
    window = PanelWindow.open(stage, 1, FaultPanel::new);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void aFaultThatIsTypedActsAndIsNamedUntilItIsEnded(FxRobot robot) {
    type(robot, "loss state 30% for 1min");

    window.until(() -> window.text("#faults-running").equals("loss state 30% for 60s"));
    assertThat(running()).containsExactly("loss state 30% for 60s");
    assertThat(window.typed("#fault-text")).isEmpty();

    robot.clickOn("#fault-clear");

    window.until(() -> running().isEmpty());
    window.until(() -> !robot.lookup("#faults-running").query().isVisible());
  }

  @Test
  void aFaultFromElsewhereIsNamed() {
    window.carryOut(new Control.InjectFault(Fault.of("pad-blind")));

    window.until(() -> window.text("#faults-running").equals("pad-blind"));
  }

  @Test
  void aMistakeIsSaidInTheLanguageOfTheWindowUntilItIsMended(FxRobot robot) {
    type(robot, "lass state 30%");

    assertThat(window.text("#fault-error")).contains("did you mean loss?");
    assertThat(window.typed("#fault-text")).isEqualTo("lass state 30%");
    window.speak(Locale.GERMAN);
    assertThat(window.text("#fault-error")).doesNotContain("did you mean").contains("loss");
    window.speak(Locale.ENGLISH);

    robot.eraseText(1);
    assertThat(robot.lookup("#fault-error").query().isVisible()).isFalse();
    robot.eraseText(20);
    type(robot, "pad-blind drone 7");
    assertThat(window.text("#fault-error")).isEqualTo("there is no drone 7, the drones are 1 to 1");
    assertThat(running()).isEmpty();
  }

  @Test
  void theLinkIsChosenAndShown(FxRobot robot) {
    ChoiceBox<LinkPreset> link = link(robot);
    assertThat(link.getValue()).isEqualTo(LinkPreset.IDEAL);

    robot.interact(() -> link.setValue(LinkPreset.CROWDED));
    window.settle();
    assertThat(window.snapshot().drones().get(0).faults().link()).isEqualTo(LinkPreset.CROWDED);

    window.carryOut(new Control.SetLink(LinkPreset.LAB));
    window.until(() -> link.getValue() == LinkPreset.LAB);
  }

  @SuppressWarnings("unchecked") // the box with this id contains presets
  private static ChoiceBox<LinkPreset> link(FxRobot robot) {
    return robot.lookup("#link-preset").queryAs(ChoiceBox.class);
  }

  private static void type(FxRobot robot, String fault) {
    robot.interact(() -> robot.lookup("#fault-text").query().requestFocus());
    robot.write(fault).type(KeyCode.ENTER);
  }

  private List<String> running() {
    return window.snapshot().drones().get(0).faults().faults().stream().map(Fault::text).toList();
  }
}
