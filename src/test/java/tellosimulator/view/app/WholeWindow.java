package tellosimulator.view.app;

import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.TimeoutException;
import javafx.scene.Node;
import javafx.scene.control.Labeled;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.image.WritableImage;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import org.testfx.api.FxToolkit;
import org.testfx.util.WaitForAsyncUtils;
import tellosimulator.goal.GoalWatch;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.network.PortTakenException;
import tellosimulator.scenario.EditedScenario;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.Control;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.settings.WindowPlacement;
import tellosimulator.view.testing.ViewContexts;
import tellosimulator.view.testing.WindowFixture;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;
import tellosimulator.view.world.Simulator3DScene;
import tellosimulator.world.Room;

/**
 * The whole window as the program opens it, with a simulation whose drones listen at free ports of
 * 127.0.0.1 and send their state nowhere (unless a test sets it otherwise). It has no frame, so
 * that its size is exactly as requested. Confined to the thread of a test.
 */
final class WholeWindow implements AutoCloseable {

  /** Maximum time for a reply, or for the first window on a slow machine [ms]. */
  private static final int PATIENCE_MS = 60_000;

  /** Ports without a receiver. */
  static final StreamPorts NOWHERE = new StreamPorts(9, 9);

  private final LogQueue logQueue = new LogQueue();
  private final Map<Integer, DatagramSocket> operators = new HashMap<>();
  private final FxScenario flown;
  private final OnlineSimulation simulation;
  private final WindowVideo video;
  private final Settings settings;
  private WindowState state;
  private ViewContext context;
  private SimulatorWindow window;
  private Stage stage;

  private WholeWindow(Scenario scenario, Path file, int firstPort) {
    settings = Settings.load(file);
    SimConfig config = scenario.config();
    GoalWatch goals = new GoalWatch(scenario.challenge(), logQueue::event);
    flown =
        new FxScenario(
            EditedScenario.of(OpenedScenario.once(scenario)),
            goals,
            goals::ask,
            ViewContexts.NO_SCENARIOS);
    List<InetAddress> loopback = List.of(InetAddress.getLoopbackAddress());
    simulation =
        new OnlineSimulation(
            config,
            AddressPlan.portPerDrone(config.starts().size(), loopback, firstPort),
            OptionalInt.empty(),
            List.of(logQueue, goals));
    video = WindowVideo.of(simulation, DroneOptics.DEFAULT, new MediaFolder(file.getParent()));
  }

  /** Shows all parts that can be folded, because tests need them to be visible. */
  static void showAllParts(WindowState state) {
    state.flag(Flag.NETWORK_CONTROLS).set(true);
    state.flag(Flag.LOG).set(true);
  }

  /** Folds the parts that are folded at the first start of the program. */
  WholeWindow asAtFirst() {
    WindowState first = new WindowState();
    change(
        () -> {
          state.flag(Flag.NETWORK_CONTROLS).set(first.flag(Flag.NETWORK_CONTROLS).get());
          state.flag(Flag.LOG).set(first.flag(Flag.LOG).get());
        });
    return this;
  }

  /**
   * Opens the window with drones in a row, in the default room, as at the first start.
   *
   * @param folder the folder for the settings
   */
  static WholeWindow ofDrones(int count, Path folder) {
    return open(
        SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(count, Vec3.ZERO, Room.DEFAULT)),
        folder.resolve("settings"));
  }

  /**
   * Opens the window.
   *
   * @param settings the file of the settings; need not exist
   */
  static WholeWindow open(SimConfig config, Path settings) {
    return open(config.withStreamPorts(NOWHERE), settings, 0);
  }

  /**
   * Opens the window with given ports instead of free ones.
   *
   * @param firstPort the command port of the first drone; the others have the subsequent ports
   */
  static WholeWindow open(SimConfig config, Path settings, int firstPort) {
    return open(Scenario.of(config), settings, firstPort);
  }

  /** Opens the window with the goals of a scenario. */
  static WholeWindow open(Scenario scenario, Path settings, int firstPort) {
    try {
      FxToolkit.registerPrimaryStage();
    } catch (TimeoutException e) {
      throw new AssertionError("the toolkit does not start", e);
    }
    WholeWindow whole = new WholeWindow(scenario, settings, firstPort);
    whole.change(whole::build);
    waitUntil(() -> whole.stage.getWidth() > 1 && whole.find("log-list").getScene() != null);
    return whole;
  }

  private void build() {
    boolean first = settings.isNew();
    state = WindowState.remembered(settings);
    if (first) {
      showAllParts(state);
    }
    Language language = new Language(Locale.ENGLISH);
    settings.bind("language", language.localeProperty(), Language.codec());
    context = ViewContext.of(simulation, language, video, flown);
    stage = new Stage(StageStyle.UNDECORATED);
    window = new SimulatorWindow(stage, context, state, logQueue);
    WindowPlacement.remember(stage, settings);
    window.remember(settings);
    stage.setOnHidden(
        hidden -> {
          window.close();
          settings.save();
        });
    window.show();
    stage.requestFocus();
  }

  OnlineSimulation simulation() {
    return simulation;
  }

  /** Returns the snapshot once all actions of the window have been carried out. */
  SimSnapshot snapshot() {
    WindowFixture.waitUntil(() -> !context.actions().pending());
    return simulation.snapshot();
  }

  ViewContext context() {
    return context;
  }

  Simulator3DScene scene() {
    return find("scene-3d", Simulator3DScene.class);
  }

  WindowState state() {
    return state;
  }

  Stage stage() {
    return stage;
  }

  /** Returns the node with this id; fails if there is none. */
  Node find(String id) {
    Node found = onFxThread(() -> stage.getScene().lookup("#" + id));
    if (found == null) {
      throw new AssertionError("no node with the id " + id);
    }
    return found;
  }

  <N extends Node> N find(String id, Class<N> type) {
    return type.cast(find(id));
  }

  String text(String id) {
    return onFxThread(() -> find(id, Labeled.class).getText());
  }

  /** Returns whether a part is visible, together with all its parents. */
  boolean shows(String id) {
    return onFxThread(
        () -> {
          boolean shown = true;
          for (Node node = find(id); node != null; node = node.getParent()) {
            shown &= node.isVisible();
          }
          return shown;
        });
  }

  /** Returns the visible lines of the log, without their times. */
  List<String> log() {
    return onFxThread(
        () ->
            find("log-list").lookupAll(".log-words").stream()
                .map(words -> ((Labeled) words).getText())
                .toList());
  }

  /** Chooses an item in a menu of the settings. */
  void choose(String menu, String item) {
    change(
        () -> {
          Menu opened = (Menu) withId(find("settings", MenuButton.class).getItems(), menu);
          withId(opened.getItems(), item).fire();
        });
  }

  private static MenuItem withId(List<MenuItem> items, String id) {
    return items.stream().filter(item -> id.equals(item.getId())).findFirst().orElseThrow();
  }

  /** Runs an action on the JavaFX thread. */
  void change(Runnable what) {
    WaitForAsyncUtils.waitForAsyncFx(PATIENCE_MS, what);
  }

  void carryOut(Control control) {
    try {
      simulation.carryOut(control);
    } catch (PortTakenException e) {
      throw new AssertionError(e);
    }
  }

  /**
   * Switches all drones on; fails if a port is taken, because the drones of another program would
   * fly instead.
   */
  void switchOn() {
    for (FxDroneModel drone : context.simulation().drones()) {
      carryOut(new Control.Power(drone.number(), true));
    }
    change(() -> context.ticker().wake());
  }

  /** Sends commands to the first drone, one after another, and returns the last reply. */
  String fly(String... commands) {
    String reply = "";
    for (String command : commands) {
      tell(1, command);
      reply = reply(1);
    }
    return reply;
  }

  /** Sends a command to a drone without waiting for the reply. */
  void tell(int drone, String command) {
    byte[] bytes = command.getBytes(StandardCharsets.US_ASCII);
    InetSocketAddress address = simulation.addresses(drone).get(0);
    try {
      operator(drone).send(new DatagramPacket(bytes, bytes.length, address));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the next reply of a drone. */
  String reply(int drone) {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    try {
      operator(drone).receive(packet);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.US_ASCII);
  }

  private DatagramSocket operator(int drone) throws SocketException {
    DatagramSocket operator = operators.get(drone);
    if (operator == null) {
      operator = new DatagramSocket(0, InetAddress.getLoopbackAddress());
      operator.setSoTimeout(PATIENCE_MS);
      operators.put(drone, operator);
    }
    return operator;
  }

  /** Waits for a number of frames. */
  void passFrames(int frames) {
    WindowFixture.passFrames(frames);
  }

  WritableImage picture() {
    return onFxThread(() -> stage.getScene().snapshot(null));
  }

  /** Closes the window as a user does; the simulation keeps running. */
  void closeWindow() {
    change(
        () -> {
          stage.getScene().getRoot().requestFocus(); // no caret blinks in a closed window
          stage.hide();
        });
  }

  @Override
  public void close() {
    closeWindow();
    operators.values().forEach(DatagramSocket::close);
    video.close();
    simulation.close();
  }
}
