package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import java.io.IOException;
import java.net.DatagramSocket;
import java.util.List;
import java.util.Locale;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.Clipboard;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.Reach;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.testing.StageExtension;

@ExtendWith(StageExtension.class)
class NetworkControlsFxTest {

  private PanelWindow window;

  @Start
  void open(Stage stage) {
    window = PanelWindow.open(stage, 1, NetworkControls::new);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void timeThatWasLostIsShownBesideTheTime(FxRobot robot) {
    Label lost = robot.lookup("#lost-time").queryAs(Label.class);
    robot.interact(
        () -> { // a busy machine may have lost some as well
          showLost(0);
          assertThat(lost.isVisible()).isFalse();
          showLost(12.34);
          assertThat(lost.getText()).isEqualTo("12.3 s lost");
          assertThat(lost.isVisible()).isTrue();
        });
  }

  private void showLost(double seconds) {
    FxSimulation simulation = window.context().simulation();
    SimSnapshot present = simulation.snapshot();
    simulation.update(
        new SimSnapshot(
            present.time(),
            new SimSnapshot.Clock(TimeFactor.REAL_TIME, false, seconds),
            present.seed(),
            present.arena(),
            present.drones()));
  }

  @Test
  void theSwitchGivesAndTakesPower(FxRobot robot) throws IOException {
    assertThat(window.text("#power")).isEqualTo("Start Drone");
    assertThat(window.text("#operator")).isEqualTo("The drone is off");

    robot.clickOn("#power");

    window.until(() -> window.drone(1).state().phase() == FlightPhase.GROUNDED);
    window.until(() -> window.text("#power").equals("Stop Drone"));
    assertThat(window.text("#operator")).isEqualTo("Waits for `command`");
    String address = "127.0.0.1:" + window.simulation().addresses(1).get(0).getPort();
    window.until(() -> window.text("#address-0").equals(address));
    assertThat(window.fly("command")).isEqualTo("ok");

    robot.clickOn("#power");

    window.until(() -> window.drone(1).state().phase() == FlightPhase.OFF);
    window.until(() -> window.text("#power").equals("Start Drone"));
    try (DatagramSocket free = new DatagramSocket(window.simulation().addresses(1).get(0))) {
      assertThat(free.isBound()).isTrue();
    }
  }

  @Test
  void theSwitchFollowsThePowerThatComesFromElsewhere(FxRobot robot) {
    window.carryOut(new Control.Power(1, true));

    window.until(() -> window.text("#power").equals("Stop Drone"));
    assertThat(robot.lookup("#power").queryAs(ToggleButton.class).isSelected()).isTrue();
  }

  @Test
  void aTakenPortIsExplainedAndAnotherPortHelps(FxRobot robot) throws IOException {
    try (DatagramSocket taken = new DatagramSocket(address("127.0.0.1", 0))) {
      String port = Integer.toString(taken.getLocalPort());
      window.enter("#command-port", port);
      robot.clickOn("#power");
      window.until(() -> !window.sentence("#power-error").isEmpty());

      window.until(() -> window.drone(1).state().phase() == FlightPhase.OFF);
      assertThat(window.sentence("#power-error"))
          .startsWith("Port " + port + " of 127.0.0.1 is taken")
          .contains("Tello simulator", "choose another command port");
      window.until(() -> window.text("#power").equals("Start Drone"));
      window.until(() -> !robot.lookup("#power").queryAs(ToggleButton.class).isSelected());
      window.speak(Locale.GERMAN);
      assertThat(window.sentence("#power-error")).startsWith("Port " + port + " von 127.0.0.1");

      int another = freePort();
      window.enter("#command-port", Integer.toString(another));
      assertThat(window.sentence("#power-error")).isEmpty();
      robot.clickOn("#power");

      window.until(() -> window.drone(1).state().phase() == FlightPhase.GROUNDED);
      assertThat(window.simulation().addresses(1)).containsExactly(address("127.0.0.1", another));
    }
  }

  private static int freePort() throws IOException {
    try (DatagramSocket socket = new DatagramSocket(address("127.0.0.1", 0))) {
      return socket.getLocalPort();
    }
  }

  @Test
  void theOperatorCanBeReleased(FxRobot robot) throws IOException {
    assertThat(robot.lookup("#release").query().isVisible()).isFalse();
    robot.clickOn("#power");
    window.fly("command");
    window.until(() -> robot.lookup("#release").query().isVisible());

    robot.clickOn("#release");

    assertThat(window.drone(1).link().sdkMode()).isFalse();
    window.until(() -> window.text("#operator").equals("Waits for `command`"));
    assertThat(robot.lookup("#release").query().isVisible()).isFalse();
  }

  @Test
  void theNetworkIsOpenedAndClosedByASwitchThatSaysWhatItDoes(FxRobot robot) {
    assertThat(window.simulation().reach()).isEqualTo(Reach.THIS_MACHINE);
    assertThat(window.text("#reach-sentence")).isEqualTo("Only this machine can fly.");

    robot.clickOn("#reachable");

    assertThat(window.simulation().reach()).isEqualTo(Reach.NETWORK);
    window.settle();
    assertThat(window.text("#reach-sentence")).isEqualTo("Other machines can fly free drones.");
    window.speak(Locale.GERMAN);
    assertThat(window.text("#reachable")).isEqualTo("Aus dem Netz erreichbar");

    robot.clickOn("#reachable");

    assertThat(window.simulation().reach()).isEqualTo(Reach.THIS_MACHINE);
  }

  @Test
  void theOperatorAndItsPacketsAreShown(FxRobot robot) throws IOException {
    robot.clickOn("#power");
    assertThat(window.text("#state-lamp")).isEqualTo("No state");

    window.fly("command", "battery?", "streamon");

    window.until(() -> window.text("#operator").startsWith("Operator 127.0.0.1:"));
    window.until(() -> window.text("#packets-in").equals("3 packets in"));
    window.until(() -> packetsOut() >= 3);
    assertThat(window.text("#state-lamp")).isEqualTo("State is sent");
    assertThat(window.text("#video-lamp")).isEqualTo("Video is sent");

    robot.clickOn("#power");
    window.until(() -> window.text("#state-lamp").equals("No state"));
    assertThat(window.text("#video-lamp")).isEqualTo("No video");
  }

  private int packetsOut() {
    return Integer.parseInt(window.text("#packets-out").replace(" packets out", ""));
  }

  @Test
  void anAddressIsCopied(FxRobot robot) {
    robot.clickOn("#power");
    String address = "127.0.0.1:" + window.simulation().addresses(1).get(0).getPort();
    window.until(() -> window.text("#address-0").equals(address));

    robot.clickOn("#copy-address-0");

    String[] copied = {""};
    robot.interact(() -> copied[0] = Clipboard.getSystemClipboard().getString());
    assertThat(copied[0]).isEqualTo(address);
  }

  @Test
  void aPortThatIsNoneIsMarkedAndSetNowhere(FxRobot robot) {
    for (String wrong : List.of("0", "65536", "-1", "abc", "88.5", "", "1e3", "NaN")) {
      window.enter("#state-port", wrong);

      assertThat(window.sentence("#state-port-error")).as(wrong).isNotEmpty();
      window.settle();
      assertThat(window.drone(1).link().statePort()).as(wrong).isEqualTo(9);

      robot.type(KeyCode.ESCAPE);
      assertThat(window.typed("#state-port")).as(wrong).isEqualTo("9");
      assertThat(window.sentence("#state-port-error")).as(wrong).isEmpty();
    }
  }

  @Test
  void stateAndVideoPortsReachTheDroneAndStayApart() {
    window.enter("#state-port", "18890");
    window.enter("#video-port", "18890");
    assertThat(window.sentence("#video-port-error"))
        .isEqualTo("State and video need different ports.");
    assertThat(window.drone(1).link().videoPort()).isEqualTo(10);

    window.enter("#video-port", "18891");

    assertThat(window.drone(1).link().statePort()).isEqualTo(18890);
    assertThat(window.drone(1).link().videoPort()).isEqualTo(18891);
    assertThat(window.sentence("#video-port-error")).isEmpty();
  }

  @Test
  void anOperatorsPortAsCommandPortIsWarnedOf() {
    for (String port : new String[] {"8889", "8890", "11111"}) {
      window.enter("#command-port", port);
      assertThat(window.sentence("#port-warning")).contains("port " + port);
      assertThat(window.simulation().addresses(1).get(0).getPort())
          .isEqualTo(Integer.parseInt(port));
    }
    window.enter("#command-port", "8879");
    assertThat(window.sentence("#port-warning")).isEmpty();
  }

  @Test
  void portsAndProductAreFixedWhileTheDroneIsOn(FxRobot robot) {
    robot.clickOn("#power");

    for (String id : new String[] {"#command-port", "#state-port", "#video-port", "#profile"}) {
      window.until(() -> robot.lookup(id).query().isDisabled());
    }

    robot.clickOn("#power");
    window.until(() -> !robot.lookup("#behaviour").query().isDisabled());
    assertThat(robot.lookup("#command-port").query().isDisabled()).isFalse();
  }

  @Test
  void profileAndBehaviorMakeAnotherProduct(FxRobot robot) {
    window.enter("#state-port", "18890");

    robot.clickOn("#profile-tello");
    window.settle();
    robot.clickOn("#behaviour-measured");

    Product chosen = new Product(Profile.TELLO, Behavior.MEASURED);
    window.until(() -> window.drone(1).product().equals(chosen));
    assertThat(window.drone(1).link().statePort()).isEqualTo(18890);

    robot.clickOn("#behaviour-measured"); // one of them is always selected
    assertThat(robot.lookup("#behaviour-measured").queryAs(ToggleButton.class).isSelected())
        .isTrue();
  }

  @Test
  void timeStandsStillAndGoesOn(FxRobot robot) {
    robot.clickOn("#pause");
    assertThat(window.snapshot().clock().paused()).isTrue();
    window.until(() -> window.text("#pause").equals("Go on"));

    window.carryOut(new Control.Pause(false));
    window.until(() -> window.text("#pause").equals("Pause"));
    assertThat(robot.lookup("#pause").queryAs(ToggleButton.class).isSelected()).isFalse();
    window.until(() -> !window.text("#simulated-time").equals("0:00.0"));
  }

  @Test
  void theClockOfAHiddenPanelStandsStillAndIsRightAtOnceWhenItIsShown(FxRobot robot) {
    window.until(() -> !window.text("#simulated-time").equals("0:00.0"));
    Node panel = robot.lookup("#network-controls").query();
    robot.interact(() -> panel.setVisible(false));
    String hidden = window.text("#simulated-time");
    passLongestPeriod();
    assertThat(window.text("#simulated-time")).isEqualTo(hidden);

    robot.interact(
        () -> {
          panel.setVisible(true);
          assertThat(window.text("#simulated-time")).isNotEqualTo(hidden);
        });
  }

  @Test
  void soIsTheClockOfACardThatIsFolded(FxRobot robot) {
    ToggleButton head = robot.lookup("#card-time").queryAs(ToggleButton.class);
    if (!head.isSelected()) {
      robot.interact(head::fire);
    }
    robot.interact(head::fire);
    String folded = window.text("#simulated-time");
    passLongestPeriod();
    assertThat(window.text("#simulated-time")).isEqualTo(folded);

    robot.interact(
        () -> {
          head.fire();
          assertThat(window.text("#simulated-time")).isNotEqualTo(folded);
        });
  }

  /** Waits until an idle window has updated its clock, which takes up to two seconds. */
  private void passLongestPeriod() {
    double then = window.simulation().snapshot().time().seconds();
    window.until(() -> window.simulation().snapshot().time().seconds() > then + 2.5);
  }

  @Test
  void timePassesAsFastAsIsChosen(FxRobot robot) {
    ComboBox<TimeFactor> factor = robot.lookup("#time-factor").queryComboBox();
    robot.interact(factor::requestFocus);
    robot.type(KeyCode.DOWN, 2);
    assertThat(window.snapshot().clock().factor()).isEqualTo(new TimeFactor(5));

    window.carryOut(new Control.SetTimeFactor(TimeFactor.MAX));
    window.until(() -> "max".equals(factor.getButtonCell().getText()));
    window.speak(Locale.GERMAN);
    assertThat(factor.getButtonCell().getText()).isEqualTo("maximal");

    window.carryOut(new Control.SetTimeFactor(new TimeFactor(0.3)));
    window.until(() -> "0,3 ×".equals(factor.getButtonCell().getText()));
    window.settle();
    assertThat(window.snapshot().clock().factor()).isEqualTo(new TimeFactor(0.3));
  }
}
