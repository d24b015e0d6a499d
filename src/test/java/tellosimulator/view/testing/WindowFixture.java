package tellosimulator.view.testing;

import atlantafx.base.theme.PrimerLight;
import java.net.InetAddress;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import javafx.animation.AnimationTimer;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.testfx.api.FxRobot;
import org.testfx.api.FxToolkit;
import org.testfx.util.WaitForAsyncUtils;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;

/**
 * A view in a stage of its own, on a simulation that runs with its drones at free ports of
 * 127.0.0.1, in English and with the light theme. Beats as in the program, once a frame. Use:
 *
 * <pre>{@code
 * @RegisterExtension final WindowFixture window = new WindowFixture(LogPane::new);
 *
 * window.robot().clickOn("#clear-log");
 * window.waitUntil(() -> window.find("log-lines", ListView.class).getItems().isEmpty());
 * }</pre>
 */
public final class WindowFixture implements BeforeEachCallback, AfterEachCallback {

  /** Longest wait for what comes soon on a machine that has nothing else to do [s]. */
  private static final int PATIENCE_SECONDS = 60;

  private static final List<InetAddress> LOOPBACK = List.of(InetAddress.getLoopbackAddress());

  /** Nobody listens there, so that test flights disturb nobody. */
  private static final StreamPorts NOWHERE = new StreamPorts(9, 9);

  private final SimConfig config;
  private final Function<ViewContext, ? extends Parent> viewMaker;
  private final FxRobot robot = new QuickRobot();
  private OnlineSimulation simulation;
  private WindowVideo video;
  private ViewContext context;
  private Parent view;
  private Stage stage;

  /**
   * One drone in the default room, whose state goes nowhere.
   *
   * @param viewMaker builds the view, on the JavaFX thread
   */
  public WindowFixture(Function<ViewContext, ? extends Parent> viewMaker) {
    this(SimConfig.DEFAULT.withStreamPorts(NOWHERE), viewMaker);
  }

  /**
   * Any simulation.
   *
   * @param viewMaker builds the view, on the JavaFX thread
   */
  public WindowFixture(SimConfig config, Function<ViewContext, ? extends Parent> viewMaker) {
    this.config = config;
    this.viewMaker = viewMaker;
  }

  @Override
  public void beforeEach(ExtensionContext test) throws TimeoutException {
    FxToolkit.registerPrimaryStage();
    simulation =
        new OnlineSimulation(
            config,
            AddressPlan.portPerDrone(config.starts().size(), LOOPBACK, 0),
            OptionalInt.empty(),
            List.of());
    video = WindowVideo.of(simulation, DroneOptics.DEFAULT, MediaFolder.ofUser());
    onFxThread(
        () -> {
          Application.setUserAgentStylesheet(new PrimerLight().getUserAgentStylesheet());
          context = ViewContexts.of(simulation, new Language(Locale.ENGLISH), video);
          view = viewMaker.apply(context);
          stage = new Stage();
          stage.setScene(new Scene(view));
          stage.show();
          context.ticker().start();
          return view;
        });
    settle();
  }

  @Override
  public void afterEach(ExtensionContext test) {
    onFxThread(
        () -> {
          context.actions().close();
          context.ticker().stop();
          closeWindows();
          return stage;
        });
    video.close();
    simulation.close();
    WaitForAsyncUtils.clearExceptions();
  }

  /**
   * Closes all windows. None keeps a text field with the focus, whose caret would blink, and cause
   * frames in the tests that follow, until it is garbage. For the JavaFX thread.
   */
  public static void closeWindows() {
    for (Window window : List.copyOf(Window.getWindows())) {
      window.getScene().getRoot().requestFocus();
      window.hide();
    }
  }

  /** What the view was built with. */
  public ViewContext context() {
    return context;
  }

  /** The core behind the view; for any thread. */
  public OnlineSimulation simulation() {
    return simulation;
  }

  /** What the simulation says when all that was done in the window has been carried out. */
  public SimSnapshot snapshot() {
    waitUntil(() -> !context.actions().pending());
    return simulation.snapshot();
  }

  /** The window. */
  public Stage stage() {
    return stage;
  }

  /** Mouse and keyboard. */
  public FxRobot robot() {
    return robot;
  }

  /** The view. */
  public <T extends Parent> T view(Class<T> type) {
    return type.cast(view);
  }

  /** The node with this id; a failure if there is none. */
  public <T extends Node> T find(String id, Class<T> type) {
    return type.cast(robot.lookup("#" + id).query());
  }

  /** Does something on the JavaFX thread, and waits for its result. */
  public static <T> T onFxThread(Callable<T> work) {
    return WaitForAsyncUtils.waitForAsyncFx(PATIENCE_SECONDS * 1000L, work);
  }

  /**
   * Waits until something is true, asking on the JavaFX thread, and the windows are laid out; a
   * failure after a minute.
   */
  public static void waitUntil(Callable<Boolean> condition) {
    waitQuietlyUntil(condition);
    settle();
  }

  /** The same, but asks the toolkit for no frame, which would be seen in an idle window. */
  public static void waitQuietlyUntil(Callable<Boolean> condition) {
    try {
      WaitForAsyncUtils.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS, () -> onFxThread(condition));
    } catch (TimeoutException e) {
      throw new AssertionError("not within " + PATIENCE_SECONDS + " s", e);
    }
  }

  /**
   * Waits until input that is under way has been handled, and all windows are laid out. A real
   * display brings input through its server, which takes some frames; Monocle brings it at once. On
   * the JavaFX thread there is nothing to wait for.
   */
  public static void settle() {
    if (!Platform.isFxApplicationThread()) {
      onFxThread(() -> true); // the robot's events are put behind what is done already
      passFrames(Boolean.getBoolean("testfx.headless") ? 1 : 4);
    }
  }

  /** Waits until the toolkit has shown some more frames. */
  public static void passFrames(int frames) {
    CountDownLatch left = new CountDownLatch(frames);
    AnimationTimer counter =
        new AnimationTimer() {
          @Override
          public void handle(long nanos) {
            left.countDown();
          }
        };
    WaitForAsyncUtils.waitForAsyncFx(PATIENCE_SECONDS * 1000L, counter::start);
    try {
      if (!left.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        throw new AssertionError("the toolkit shows no frames");
      }
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    } finally {
      WaitForAsyncUtils.waitForAsyncFx(PATIENCE_SECONDS * 1000L, counter::stop);
    }
  }
}
