package tellosimulator.view.app;

import javafx.animation.AnimationTimer;
import javafx.stage.Stage;

/**
 * Restores the size of a stage that shrinks while the window manager opens it. With OpenJFX 21,
 * some window managers leave a window at 200 × 200 pixels or at its minimum size, because the
 * toolkit answers late messages of the window manager with outdated sizes. Measured with openbox
 * 3.6: this happens 0.2 s after the window is shown. Confined to the JavaFX thread.
 */
final class InitialStageSize extends AnimationTimer {

  /**
   * The minimum time for which the size is kept [ns]. Decided: shorter than the time that a user
   * needs to resize the window.
   */
  private static final long HOLD_NANOS = 1_000_000_000;

  /**
   * The minimum number of frames for which the size is kept. Decided: slow machines take longer
   * than {@link #HOLD_NANOS} to open a window.
   */
  private static final int HOLD_FRAMES = 30;

  private final Stage stage;
  private final double width;
  private final double height;
  private long firstNanos;
  private int frames;

  private InitialStageSize(Stage stage) {
    this.stage = stage;
    width = stage.getWidth();
    height = stage.getHeight();
  }

  /** Keeps the size of a window that has just been shown. */
  static void hold(Stage stage) {
    new InitialStageSize(stage).start();
  }

  @Override
  public void handle(long nanos) {
    if (firstNanos == 0) {
      firstNanos = nanos;
    }
    frames++;
    boolean open = nanos - firstNanos > HOLD_NANOS && frames > HOLD_FRAMES;
    if (open || stage.isMaximized() || stage.isFullScreen()) {
      stop();
    } else if (stage.getWidth() < width || stage.getHeight() < height) {
      stage.setWidth(width);
      stage.setHeight(height);
    }
  }
}
