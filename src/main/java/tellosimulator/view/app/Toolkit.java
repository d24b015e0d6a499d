package tellosimulator.view.app;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.LastWords;

/** Starts JavaFX if this machine can show a window. Confined to the main thread. */
public final class Toolkit {

  private static final Logger LOG = LoggerFactory.getLogger(Toolkit.class);

  /**
   * The property that makes JavaFX accept software renderers, such as Mesa's, for 3D. By default,
   * JavaFX refuses them. Measured: without the property, there is no 3D under Xvfb.
   */
  private static final String FORCE_GPU = "prism.forceGPU";

  private static final String WHAT_HELPS =
      "For a smoother picture on Linux, install libgl1 and libgl1-mesa-dri (Fedora: libglvnd-glx, mesa-dri-drivers).";

  private Toolkit() {}

  /**
   * Starts JavaFX and waits until it is running.
   *
   * @return the reason why no window can be opened; empty if JavaFX is running
   */
  public static Optional<ToolkitFailure> start() throws InterruptedException {
    if (System.getProperty(FORCE_GPU) == null) {
      System.setProperty(FORCE_GPU, "true");
    }
    if (nativesAreThere() && !NativeCache.ofThisUser().prepare()) {
      return Optional.of(ToolkitFailure.NO_ROOM);
    }
    Platform.setImplicitExit(false); // otherwise JavaFX would exit before the first window
    CountDownLatch running = new CountDownLatch(1);
    try {
      Platform.startup(running::countDown);
    } catch (RuntimeException | LinkageError e) {
      LOG.debug("JavaFX does not start", e);
      return Optional.of(ToolkitFailure.because(e, nativesAreThere()));
    }
    running.await();
    if (!Platform.isSupported(ConditionalFeature.SCENE3D)) {
      LOG.warn("The processor draws the room, as this display cannot do 3D. {}", WHAT_HELPS);
    }
    return Optional.empty();
  }

  /**
   * Shows a window in a new stage, waits until it is closed, and then stops JavaFX. JavaFX must be
   * running.
   *
   * @param show shows the window in a stage; called on the JavaFX thread
   * @return whether the window was shown; if not, the reason is logged
   */
  static boolean run(Consumer<Stage> show) throws InterruptedException {
    String display = System.getenv("DISPLAY");
    if (display != null) {
      LastWords.prepare(
          "The simulator ended unexpectedly: its display "
              + display
              + " is gone, or it was killed.");
    }
    boolean shown = showUntilClosed(show);
    Platform.exit();
    return shown;
  }

  /** Does the same as {@link #run}, but leaves JavaFX running. */
  static boolean showUntilClosed(Consumer<Stage> show) throws InterruptedException {
    CountDownLatch closed = new CountDownLatch(1);
    AtomicBoolean shown = new AtomicBoolean();
    Platform.runLater(
        () -> {
          try {
            Stage stage = new Stage();
            AppIcon.show(stage);
            stage.addEventHandler( // later, because other handlers of this event save settings
                WindowEvent.WINDOW_HIDDEN, hidden -> Platform.runLater(closed::countDown));
            show.accept(stage);
            shown.set(true);
          } finally {
            if (!shown.get()) {
              closed.countDown(); // otherwise the program would wait forever
            }
          }
        });
    closed.await();
    return shown.get();
  }

  private static boolean nativesAreThere() {
    return Platform.class.getResource("/" + System.mapLibraryName("glass")) != null;
  }
}
