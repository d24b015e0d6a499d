package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.stream.Collectors;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Label;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.testfx.api.FxRobot;
import tellosimulator.math.Pose;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.testing.QuickRobot;

/** The view for a class, and the command that prepares the window for the next group. */
class ProjectorViewFxTest {

  private final FxRobot robot = new QuickRobot();
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
    for (String part :
        new String[] {"window-bar", "simulator-controls", "log", "demo-flight", "inset-toggle"}) {
      assertThat(window.shows(part)).as(part).isFalse();
    }
    assertThat(onFxThread(() -> window.find("projector-clock", Label.class).getFont().getSize()))
        .isGreaterThan(20);

    robot.type(KeyCode.ESCAPE);
    assertThat(window.shows("projector")).isFalse();
    assertThat(window.shows("window-bar")).isTrue();
    assertThat(window.shows("demo-flight")).isTrue();
    assertThat(window.shows("inset-toggle")).isTrue();

    project();
    project();
    assertThat(window.shows("projector")).isFalse();
    assertThat(window.state().flag(Flag.FULL_SCREEN).get()).as("as before").isFalse();
  }

  @Test
  void theLastCommandAndItsOutcomeAreToBeRead() {
    window.switchOn();
    project();

    window.fly("command", "takeoff");
    waitUntil(() -> window.text("projector-command-text").equals("takeoff"));
    waitUntil(() -> window.text("projector-command-outcome").equals("ok"));
    window.tell(1, "up 9999");
    String refusal = window.reply(1);
    waitUntil(() -> window.text("projector-command-text").equals("up 9999"));
    waitUntil(() -> window.text("projector-command-outcome").equals(refusal));
    assertThat(window.text("projector-command-reason")).contains("9999");

    project();
    assertThat(window.text("last-command-text")).isEqualTo("up 9999");
    assertThat(window.text("last-command-outcome")).isEqualTo(refusal);
    assertThat(window.text("last-command-reason")).contains("9999");
  }

  /**
   * The camera is fitted to the space beside the boxes, and would otherwise move with each word.
   */
  @Test
  void theBoxOfTheLastCommandDoesNotShrink() {
    window.switchOn();
    project();
    window.tell(1, "command");
    assertThat(window.reply(1)).isEqualTo("ok");
    window.tell(1, "go 500 400 300 100");
    String refusal = window.reply(1);
    waitUntil(() -> window.text("projector-command-outcome").equals(refusal));
    window.passFrames(3);
    Bounds largest = onFxThread(() -> bounds("projector-command"));

    window.tell(1, "stop");
    waitUntil(() -> window.text("projector-command-text").equals("stop"));
    window.passFrames(3);

    assertThat(onFxThread(() -> bounds("projector-command"))).isEqualTo(largest);
  }

  @Test
  void oneDroneAndTheLastCommandShareARow() {
    window.switchOn();
    project();
    window.fly("command", "takeoff");
    waitUntil(() -> window.text("projector-command-outcome").equals("ok"));

    Bounds drone = onFxThread(() -> bounds("projector-drone-1"));
    Bounds command = onFxThread(() -> bounds("projector-command"));

    assertThat(command.getMinX()).isGreaterThan(drone.getMaxX());
    assertThat(command.getMinY()).isLessThan(drone.getMaxY());
    assertThat(drone.getMaxX()).as("as wide as its text").isLessThan(640);
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 20})
  void severalDronesLeaveTheMostOfThePictureFree(int count) {
    window.close();
    window = WholeWindow.ofDrones(count, folder);
    window.switchOn();
    project();
    window.tell(count, "command");
    assertThat(window.reply(count)).isEqualTo("ok");
    waitUntil(() -> window.shows("projector-command"));
    window.passFrames(5);

    Bounds first = onFxThread(() -> bounds("projector-drone-1"));
    Bounds command = onFxThread(() -> bounds("projector-command"));
    Bounds all = onFxThread(() -> bounds("projector"));

    assertThat(all.getMaxY() - first.getMinY())
        .as("a row, or three of them")
        .isLessThan(all.getHeight() * (count == 3 ? 0.14 : 0.32));
    assertThat(command.getMaxX()).isLessThanOrEqualTo(all.getMaxX());
  }

  @Test
  void aDroneAmongOthersSaysWhatItDoesOnlyInTrouble() {
    window.close();
    window = WholeWindow.ofDrones(2, folder);
    window.switchOn();
    project();
    window.fly("command", "takeoff");
    waitUntil(() -> chip(1).matches("1 \\d+ %"));

    window.tell(1, "emergency");
    waitUntil(() -> chip(1).contains("falling") || chip(1).contains("crashed"));
  }

  /** Returns the text on the chip of a drone. */
  private String chip(int drone) {
    return onFxThread(
        () ->
            window.find("projector-drone-" + drone, Parent.class).getChildrenUnmodifiable().stream()
                .filter(Node::isVisible)
                .map(label -> ((Label) label).getText())
                .collect(Collectors.joining(" ")));
  }

  private Bounds bounds(String id) {
    Node node = window.find(id, Node.class);
    return node.localToScene(node.getLayoutBounds());
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
    assertThat(drone().link().operator()).as("who sends `command` next").isEmpty();
  }

  @Test
  void theNextGroupHasTheClockAndTheCommandOfItsOwn() {
    window.switchOn();
    project();
    window.fly("command", "takeoff");
    waitUntil(() -> window.shows("projector-command"));
    waitUntil(() -> !window.text("projector-clock").equals("0:00"));

    robot.press(KeyCode.CONTROL, KeyCode.SHIFT).type(KeyCode.N);
    robot.release(KeyCode.SHIFT, KeyCode.CONTROL);

    waitUntil(() -> window.text("projector-clock").equals("0:00"));
    waitUntil(() -> !window.shows("projector-command"));
  }

  private DroneSnapshot drone() {
    return window.snapshot().drones().get(0);
  }

  private void project() {
    robot.press(KeyCode.SHIFT).type(KeyCode.F11).release(KeyCode.SHIFT);
  }
}
