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

/** Starts JavaFX, if this machine can show a window. For the main thread. */
public final class Toolkit {

  private static final Logger LOG = LoggerFactory.getLogger(Toolkit.class);

  /**
   * Lets JavaFX do 3D by software renderers such as Mesa's, which it otherwise refuses. Measured:
   * without it there is no 3D under Xvfb.
   */
  private static final String FORCE_GPU = "prism.forceGPU";

  private static final String WHAT_HELPS =
      "For a smoother picture on Linux, install libgl1 and libgl1-mesa-dri (Fedora: libglvnd-glx, mesa-dri-drivers).";

  private Toolkit() {}

  /**
   * Starts JavaFX and waits until it runs.
   *
   * @return nothing, or why there cannot be a window
   */
  public static Optional<ToolkitFailure> start() throws InterruptedException {
    if (System.getProperty(FORCE_GPU) == null) {
      System.setProperty(FORCE_GPU, "true");
    }
    if (nativesAreThere() && !NativeCache.ofThisUser().prepare()) {
      return Optional.of(ToolkitFailure.NO_ROOM);
    }
    Platform.setImplicitExit(false); // or it would end at once, as it has no window yet
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
   * Shows a window in a stage of its own, returns after it was closed, and ends JavaFX, which must
   * run.
   *
   * @param show what shows it; called on the JavaFX thread
   * @return whether there was a window; if not, the log says why
   */
  static boolean run(Consumer<Stage> show) throws InterruptedException {
    boolean shown = showUntilClosed(show);
    Platform.exit();
    return shown;
  }

  /** The same, but leaves JavaFX running. */
  static boolean showUntilClosed(Consumer<Stage> show) throws InterruptedException {
    CountDownLatch closed = new CountDownLatch(1);
    AtomicBoolean shown = new AtomicBoolean();
    Platform.runLater(
        () -> {
          try {
            Stage stage = new Stage();
            AppIcon.show(stage);
            stage.addEventHandler( // later, as other handlers of this event save what is to be kept
                WindowEvent.WINDOW_HIDDEN, hidden -> Platform.runLater(closed::countDown));
            show.accept(stage);
            shown.set(true);
          } finally {
            if (!shown.get()) {
              closed.countDown(); // or the program would go on, with nothing to be seen of it
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
