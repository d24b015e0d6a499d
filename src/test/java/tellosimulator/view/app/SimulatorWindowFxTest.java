package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.net.BindException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import javafx.scene.Node;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.Region;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import tellosimulator.command.Peer;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.time.TimeFactor;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.world.ViewCamera;

/** The window as a whole: the effects of its buttons and keys, and its settings. */
class SimulatorWindowFxTest {

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
  void buttonAndKeyHideAPartAndShowItAgain() {
    assertHidesAndShows("show-controls", KeyCode.F2, "simulator-controls");
    assertHidesAndShows("show-network", KeyCode.F3, "network-controls");
  }

  private void assertHidesAndShows(String button, KeyCode key, String part) {
    double before = sceneArea();

    robot.clickOn("#" + button);
    assertThat(window.shows(part)).isFalse();
    waitUntil(() -> sceneArea() > before);
    robot.type(key);
    assertThat(window.shows(part)).isTrue();
    assertThat(selected(button)).isTrue();
    waitUntil(() -> sceneArea() == before);
    robot.type(key);
    assertThat(window.shows(part)).isFalse();
    assertThat(selected(button)).isFalse();
  }

  @Test
  void buttonAndKeyFoldTheLogToItsNewestLineAndUnfoldIt() {
    double before = sceneArea();

    robot.clickOn("#show-log");
    assertThat(window.shows("log-list")).isFalse();
    assertThat(window.shows("log-unfold")).isTrue();
    waitUntil(() -> sceneArea() > before);
    robot.type(KeyCode.F4);
    assertThat(window.shows("log-list")).isTrue();
    assertThat(selected("show-log")).isTrue();
    waitUntil(() -> sceneArea() == before);
  }

  @Test
  void atFirstTheRoomHasMostOfTheWindowAndTheDroneIsStartedBelowIt() throws SocketException {
    window.asAtFirst();
    assertThat(window.shows("network-controls")).isFalse();
    assertThat(window.shows("log-list")).isFalse();
    double all = window.stage().getScene().getWidth() * window.stage().getScene().getHeight();
    waitUntil(() -> sceneArea() > 0.65 * all);

    robot.clickOn("#pilot-power");
    waitUntil(() -> window.context().simulation().selected().onProperty().get());
    assertThat(window.text("pilot-power")).isEqualTo("Stop Drone");
    robot.clickOn("#pilot-power");
    waitUntil(() -> !window.context().simulation().selected().onProperty().get());

    try (DatagramSocket other = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      window.change(
          () -> window.context().actions().setCommandPort(1, other.getLocalPort(), () -> {}));
      robot.clickOn("#pilot-power");
      String port = "ort " + other.getLocalPort() + " of 127.0.0.1 is taken";
      waitUntil(() -> window.text("pilot-problem").contains(port));
      assertThat(selected("pilot-power")).isFalse();
    }

    robot.type(KeyCode.F3);
    assertThat(window.shows("power")).isTrue();
    assertThat(window.shows("pilot-power")).as("there is one switch").isFalse();
  }

  @Test
  void whileTimeStandsStillTheRoomSaysSo() {
    assertThat(window.shows("pause-notice")).isFalse();
    robot.type(KeyCode.F9);
    waitUntil(() -> window.shows("pause-notice"));
    robot.type(KeyCode.F9);
    waitUntil(() -> !window.shows("pause-notice"));
  }

  @Test
  void theBarSaysWhereTheDroneIsReachedAndWhetherAProgramIsThere() {
    window.asAtFirst();
    assertThat(window.text("show-network")).endsWith(" · off");

    window.switchOn();
    waitUntil(() -> window.text("show-network").endsWith(" · waiting"));
    String address = "127.0.0.1:" + window.simulation().addresses(1).get(0).getPort();
    waitUntil(() -> window.text("show-network").startsWith(address));

    assertThat(window.fly("command")).isEqualTo("ok");
    waitUntil(() -> window.text("show-network").equals(address + " · connected"));
    robot.clickOn("#show-network");
    assertThat(window.shows("network-controls")).isTrue();
  }

  @Test
  void thePlanLiesOverTheSceneAndTakesTheKeys() {
    robot.type(KeyCode.F10);
    assertThat(window.shows("plan-pane")).isTrue();
    assertThat(window.shows("demo-flight")).isFalse();

    robot.clickOn("#plan-add-box");
    assertThat(window.snapshot().arena().obstacles()).hasSize(1);
    robot.type(KeyCode.DELETE);
    assertThat(window.snapshot().arena().obstacles()).isEmpty();

    robot.type(KeyCode.ESCAPE);
    assertThat(window.shows("plan-pane")).isFalse();
    assertThat(selected("show-plan")).isFalse();
    assertThat(window.shows("demo-flight")).isTrue();
  }

  @Test
  void helpAndAboutOpenAndClose() {
    robot.clickOn("#power").type(KeyCode.F1);
    assertThat(window.shows("help-page")).isTrue();
    waitUntil(() -> window.simulation().addresses(1).get(0).getPort() > 0);
    String drone = "127.0.0.1:" + window.simulation().addresses(1).get(0).getPort();
    waitUntil(() -> window.text("help-step-2").contains(drone));
    robot.type(KeyCode.ESCAPE);
    assertThat(window.shows("page-overlay")).isFalse();

    robot.clickOn("#help");
    Node help = window.find("help-page");
    double lowest = onFxThread(() -> help.localToScene(help.getBoundsInLocal()).getMaxY());
    assertThat(lowest)
        .as("its lower edge")
        .isLessThanOrEqualTo(window.stage().getScene().getHeight());
    robot.clickOn("#help-close");
    assertThat(window.shows("page-overlay")).isFalse();

    robot.clickOn("#settings").clickOn("#about");
    assertThat(window.shows("about-page")).isTrue();
    robot.clickOn("#about-close");
    assertThat(window.shows("page-overlay")).isFalse();
  }

  @Test
  void theOpenHelpTellsThePortAsSoonAsTheDroneHasOne() {
    robot.type(KeyCode.F1);
    assertThat(window.shows("help-page")).isTrue();

    window.switchOn();

    String drone = "127.0.0.1:" + window.simulation().addresses(1).get(0).getPort();
    waitUntil(() -> window.text("help-step-2").contains(drone));
  }

  @Test
  void atFirstNoButtonHasTheFocusSoSpacePressesNone() {
    robot.type(KeyCode.SPACE, KeyCode.ENTER);

    assertThat(window.text("demo-flight")).isEqualTo("Demo flight");
    assertThat(window.context().simulation().selected().onProperty().get()).isFalse();
  }

  @Test
  void cameraButtonsAndKeyAgree() {
    robot.clickOn("#camera").clickOn("#view-drone");
    assertLooksThrough(ViewCamera.DRONE);
    robot.clickOn("#camera-switch");
    assertLooksThrough(ViewCamera.SIMULATOR);
    robot.type(KeyCode.DIGIT5);
    assertLooksThrough(ViewCamera.DRONE);
    robot.type(KeyCode.DIGIT5);
    assertLooksThrough(ViewCamera.SIMULATOR);
    robot.clickOn("#camera-switch").type(KeyCode.DIGIT0);
    assertLooksThrough(ViewCamera.SIMULATOR);
  }

  private void assertLooksThrough(ViewCamera camera) {
    boolean drones = camera == ViewCamera.DRONE;
    assertThat(window.scene().viewCameraProperty().get()).isEqualTo(camera);
    assertThat(window.text("camera")).isEqualTo(drones ? "Drone camera" : "Start view");
    assertThat(selected("camera-switch")).isEqualTo(drones);
    assertThat(window.text("camera-switch")).isEqualTo(drones ? "Room camera" : "Drone camera");
  }

  @Test
  void theCamerasButtonNamesTheViewUntilAHandMovesIt() {
    robot.type(KeyCode.DIGIT3);
    assertThat(window.text("camera")).isEqualTo("Top");
    robot.clickOn("#camera").clickOn("#view-side");
    assertThat(window.text("camera")).isEqualTo("Side");
    robot.drag("#scene-3d", MouseButton.PRIMARY).moveBy(40, 0).drop();
    assertThat(window.text("camera")).isEqualTo("Own view");
    robot.type(KeyCode.DIGIT0);
    assertThat(window.text("camera")).isEqualTo("Start view");
  }

  @Test
  void followingIsASwitchOfItsOwn() {
    robot.clickOn("#view-follow").type(KeyCode.DIGIT2);
    assertThat(window.scene().camera().followingProperty().get()).isTrue();
    assertThat(window.text("camera")).isEqualTo("Side");
    robot.type(KeyCode.DIGIT6);
    assertThat(selected("view-follow")).isFalse();
    robot.type(KeyCode.DIGIT6).clickOn("#view-fit");
    assertThat(selected("view-follow")).isFalse();
  }

  @Test
  void pausingStopsTheCore() {
    robot.type(KeyCode.F9);
    assertThat(window.snapshot().clock().paused()).isTrue();
    waitUntil(() -> window.text("pause").equals("Go on"));

    robot.type(KeyCode.F9);
    assertThat(window.snapshot().clock().paused()).isFalse();
  }

  @Test
  void theLogIsAsHighAsItsHandleIsPulled() {
    double before = height("log");

    robot.drag("#log-handle", MouseButton.PRIMARY).moveBy(0, -100).drop();
    waitUntil(() -> height("log") > before + 80);
    assertThat(height("log")).isBetween(before + 90, before + 110);
    robot.drag("#log-handle", MouseButton.PRIMARY).moveBy(0, -450).drop();
    waitUntil(() -> height("log") > before + 110);
    assertThat(height("scene-3d")).isGreaterThan(100);
    robot.doubleClickOn("#log-handle");
    waitUntil(() -> height("log") == before);
  }

  @Test
  void whatWasSwitchedIsThereInTheNextWindow() {
    robot.type(KeyCode.F3, KeyCode.F7).clickOn("#log-timestamps");
    window.choose("theme", "theme-dark");
    window.choose("language", "language-de");
    robot.drag("#log-handle", MouseButton.PRIMARY).moveBy(0, -60).drop();
    double logHeight = window.state().logHeightProperty().get();
    window.close();

    open();

    assertThat(window.state().themeProperty().get()).isEqualTo(Theme.DARK);
    assertThat(window.shows("network-controls")).isFalse();
    assertThat(window.shows("simulator-controls")).isTrue();
    assertThat(selected("show-trail")).isFalse();
    assertThat(selected("log-timestamps")).isFalse();
    assertThat(window.text("reset")).isEqualTo("Drohne zurück");
    assertThat(window.state().logHeightProperty().get()).isEqualTo(logHeight).isGreaterThan(200);
  }

  @Test
  void aTakenPortIsExplainedInThePanelAndInTheLog() throws SocketException {
    try (DatagramSocket other = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      window.change(
          () -> window.context().actions().setCommandPort(1, other.getLocalPort(), () -> {}));

      robot.clickOn("#power");

      String port = "ort " + other.getLocalPort() + " of 127.0.0.1 is taken";
      waitUntil(() -> window.text("power-error").contains(port));
      waitUntil(() -> window.log().stream().anyMatch(line -> line.contains(port)));
      assertThat(window.text("power")).isEqualTo("Start Drone");
      assertThat(selected("power")).isFalse();
    }
  }

  @Test
  void closingWhileFlyingEndsTheOperatorsSocketAndTheBeat() {
    AtomicInteger beats = new AtomicInteger();
    window.change(() -> window.context().ticker().onTick(nanos -> beats.incrementAndGet()));
    window.carryOut(new Control.SetTimeFactor(new TimeFactor(5)));
    robot.clickOn("#demo-flight");
    waitUntil(() -> window.context().simulation().selected().phaseProperty().get().flying());
    InetSocketAddress operator =
        onFxThread(
            () ->
                window
                    .context()
                    .simulation()
                    .selected()
                    .snapshotProperty()
                    .get()
                    .link()
                    .operator()
                    .map(Peer::address)
                    .orElseThrow());
    assertThatThrownBy(() -> new DatagramSocket(operator).close())
        .isInstanceOf(BindException.class);

    window.closeWindow();

    assertThatCode(() -> new DatagramSocket(operator).close()).doesNotThrowAnyException();
    int last = beats.get();
    window.passFrames(5);
    assertThat(beats).hasValue(last);
  }

  private boolean selected(String id) {
    return window.find(id, ToggleButton.class).isSelected();
  }

  private double height(String id) {
    return window.find(id, Region.class).getHeight();
  }

  private double sceneArea() {
    return window.scene().getWidth() * window.scene().getHeight();
  }
}
