package tellosimulator.view.app;

import static tellosimulator.view.testing.WindowFixture.onFxThread;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.control.Labeled;
import javafx.stage.Stage;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.testfx.api.FxRobot;
import org.testfx.api.FxToolkit;
import tellosimulator.network.AddressPlan;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.testing.WindowFixture;

/**
 * The program with its window, in which scenarios are opened and saved: one drone that is off, at a
 * free port of 127.0.0.1, and default settings.
 */
final class AppFixture implements BeforeEachCallback, AfterEachCallback {

  static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();

  private final Supplier<Stage> stageMaker;
  private final FxRobot robot = new QuickRobot();
  private final List<Path> openedReports = new CopyOnWriteArrayList<>();
  private volatile Predicate<Path> browser = file -> true;
  private Path settingsFile;
  private boolean galleryFirst;
  private boolean asAtFirst;
  private WindowState state;
  private SimulatorApp app;
  private Stage stage;

  /**
   * @param stageMaker creates the window's stage, on the JavaFX thread
   */
  AppFixture(Supplier<Stage> stageMaker) {
    this.stageMaker = stageMaker;
  }

  @Override
  public void beforeEach(ExtensionContext test) throws IOException, TimeoutException {
    FxToolkit.registerPrimaryStage();
    settingsFile = Files.createTempDirectory("settings").resolve("settings");
    begin();
  }

  /** Starts as the program does without options: with the gallery at the first start. */
  AppFixture beginningWithGallery() {
    galleryFirst = true;
    return this;
  }

  /** Folds the parts that are folded at the first start of the program. */
  AppFixture asAtFirst() {
    asAtFirst = true;
    return this;
  }

  /** Starts the program again, after its window was closed. */
  void startAgain() {
    app.close();
    begin();
  }

  private void begin() {
    Settings settings = Settings.load(settingsFile);
    app =
        new SimulatorApp(
            OpenedScenario.once(
                Scenario.of(SimConfig.DEFAULT.withStreamPorts(new SimConfig.StreamPorts(9, 10)))),
            new SimulatorApp.Rules(
                UnaryOperator.identity(),
                scenario ->
                    AddressPlan.portPerDrone(
                        scenario.config().drones().size(), List.of(LOOPBACK), 0),
                OptionalInt.empty(),
                new SimulatorApp.Recordings(
                    RecordingFolder.at(settingsFile.resolveSibling("recordings")),
                    false,
                    List.of())),
            DroneOptics.DEFAULT,
            this::openReport);
    if (galleryFirst) {
      app.beginWithGallery();
    }
    change(
        () -> {
          stage = stageMaker.get();
          boolean first = settings.isNew();
          state = WindowState.remembered(settings);
          if (first && !asAtFirst) {
            WholeWindow.showAllParts(state);
          }
          app.show(stage, settings, state);
        });
  }

  @Override
  public void afterEach(ExtensionContext test) throws IOException {
    change(stage::hide);
    app.close();
    try (Stream<Path> all = Files.walk(settingsFile.getParent())) {
      for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }

  private boolean openReport(Path file) {
    openedReports.add(file);
    return browser.test(file);
  }

  /** Returns the window's state. */
  WindowState state() {
    return state;
  }

  /** Returns the reports that were opened, in order. */
  List<Path> openedReports() {
    return openedReports;
  }

  /** Makes opening reports impossible from now on. */
  void removeBrowser() {
    browser = file -> false;
  }

  /** Makes opening a report fail with an unexpected exception from now on. */
  void breakBrowser() {
    browser =
        file -> {
          throw new IllegalStateException("broken on purpose");
        };
  }

  /** Returns the file of the settings; it exists once something was changed. */
  Path settings() {
    return settingsFile;
  }

  /** Returns the folder for recorded flights; it exists once there is one. */
  Path recordings() {
    return settingsFile.resolveSibling("recordings");
  }

  SimulatorApp app() {
    return app;
  }

  Stage stage() {
    return stage;
  }

  FxRobot robot() {
    return robot;
  }

  String label(String id) {
    return robot.lookup("#" + id).queryAs(Label.class).getText();
  }

  /** Returns the text of the window's log. */
  String log() {
    return stage.getScene().lookup("#log-list").lookupAll(".log-words").stream()
        .map(words -> ((Labeled) words).getText())
        .toList()
        .toString();
  }

  /** Runs an action on the JavaFX thread, and waits until the window has handled it. */
  static void change(Runnable work) {
    onFxThread(
        () -> {
          work.run();
          return true;
        });
    WindowFixture.settle();
  }
}
