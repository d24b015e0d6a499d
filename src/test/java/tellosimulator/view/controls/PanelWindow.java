package tellosimulator.view.controls;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;

import atlantafx.base.theme.PrimerLight;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import javafx.application.Application;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.control.Labeled;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import org.testfx.api.FxRobot;
import org.testfx.service.query.EmptyNodeQueryException;
import org.testfx.util.WaitForAsyncUtils;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.testing.ViewContexts;
import tellosimulator.view.testing.WindowFixture;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;
import tellosimulator.world.Room;

/** A panel on its own simulation, whose drones listen at addresses chosen by the system. */
final class PanelWindow implements AutoCloseable {

  private static final int UNUSED_PORT = 9;

  private final OnlineSimulation simulation;
  private final Language language = new Language(Locale.ENGLISH);
  private final ViewContext context;
  private final FxRobot robot = new QuickRobot();

  private PanelWindow(int drones) {
    InetAddress loopback = address("127.0.0.1", 0).getAddress();
    simulation =
        new OnlineSimulation(
            SimConfig.DEFAULT
                .withRoom(Room.DEFAULT, Formation.row(drones, Vec3.ZERO, Room.DEFAULT))
                .withStreamPorts(new SimConfig.StreamPorts(UNUSED_PORT, UNUSED_PORT + 1)),
            AddressPlan.of(Collections.nCopies(drones, loopback), 0),
            OptionalInt.empty(),
            List.of());
    context =
        ViewContexts.of(
            simulation,
            language,
            WindowVideo.of(simulation, DroneOptics.DEFAULT, MediaFolder.ofUser()));
  }

  /** Opens a panel. Called on the JavaFX thread. */
  static PanelWindow open(Stage stage, int drones, Function<ViewContext, Parent> panel) {
    PanelWindow window = new PanelWindow(drones);
    Application.setUserAgentStylesheet(new PrimerLight().getUserAgentStylesheet());
    stage.setScene(new Scene(panel.apply(window.context), 300, 780));
    stage.show();
    window.context.ticker().start();
    return window;
  }

  /** Returns the simulation once all actions of the user have been carried out. */
  OnlineSimulation simulation() {
    until(() -> !context.actions().pending());
    return simulation;
  }

  ViewContext context() {
    return context;
  }

  /** Returns the snapshot once all actions of the user have been carried out. */
  SimSnapshot snapshot() {
    until(() -> !context.actions().pending());
    return simulation.snapshot();
  }

  /** Carries out a control directly, without the window. */
  void carryOut(Control control) {
    try {
      simulation.carryOut(control);
    } catch (PortTakenException e) {
      throw new AssertionError(e);
    }
  }

  DroneSnapshot drone(int number) {
    return snapshot().drones().get(number - 1);
  }

  String text(String id) {
    return robot.lookup(id).queryAs(Labeled.class).getText();
  }

  /** Returns the text in a field. */
  String typed(String id) {
    return robot.lookup(id).queryTextInputControl().getText();
  }

  /** Returns the message below a field; empty if there is none. */
  String sentence(String id) {
    Label label = robot.lookup(id).queryAs(Label.class);
    assertThat(label.isVisible()).isEqualTo(!label.getText().isEmpty());
    return label.getText();
  }

  /** Types a text into a field as a user does, without Enter. */
  void type(String id, String text) {
    robot.clickOn(id);
    robot.press(KeyCode.CONTROL).type(KeyCode.A).release(KeyCode.CONTROL).type(KeyCode.DELETE);
    robot.write(text);
  }

  /** Types a text and Enter, and waits until its effect is shown. */
  void enter(String id, String text) {
    type(id, text);
    robot.type(KeyCode.ENTER);
    settle();
  }

  void speak(Locale locale) {
    robot.interact(() -> language.localeProperty().set(locale));
  }

  /**
   * Waits for a condition, which may fail with an exception while nodes are missing or incomplete.
   */
  void until(Callable<Boolean> condition) {
    try {
      WaitForAsyncUtils.waitFor(20, TimeUnit.SECONDS, () -> holds(condition));
    } catch (TimeoutException e) {
      throw new AssertionError("it never became true", e);
    }
  }

  private static boolean holds(Callable<Boolean> condition) throws Exception {
    try {
      return condition.call();
    } catch (EmptyNodeQueryException | AssertionError notYet) {
      return false;
    }
  }

  /** Waits until all actions have been carried out and are shown. */
  void settle() {
    until(() -> !context.actions().pending());
    robot.interact(() -> context.ticker().wake()); // otherwise it might tick only twice a second
    WindowFixture.passFrames(2);
  }

  /** Sends commands, one after another, and returns the last reply. */
  String fly(String... commands) throws IOException {
    until(() -> drone(1).state().phase() != FlightPhase.OFF);
    InetSocketAddress drone = simulation.addresses(1).get(0);
    try (DatagramSocket socket = new DatagramSocket(address("127.0.0.1", 0))) {
      socket.setSoTimeout(20_000);
      String reply = "";
      for (String command : commands) {
        byte[] bytes = command.getBytes(StandardCharsets.ISO_8859_1);
        socket.send(new DatagramPacket(bytes, bytes.length, drone));
        DatagramPacket answer = new DatagramPacket(new byte[2048], 2048);
        socket.receive(answer);
        reply = new String(answer.getData(), 0, answer.getLength(), StandardCharsets.ISO_8859_1);
      }
      return reply;
    }
  }

  @Override
  public void close() {
    robot.interact(() -> context.ticker().stop());
    context.actions().close();
    context.video().close();
    simulation.close();
  }
}
