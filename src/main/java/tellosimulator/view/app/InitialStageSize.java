package tellosimulator.view.app;

import javafx.animation.AnimationTimer;
import javafx.stage.Stage;

/**
 * Holds the size of a stage while the window manager opens it. With OpenJFX 21 some window managers
 * leave a window at 200 × 200 pixels or at its least size, because the toolkit answers their late
 * messages with sizes from before. Measured: openbox 3.6, a fifth of a second after the window was
 * shown. For the JavaFX thread.
 */
final class InitialStageSize extends AnimationTimer {

  /** How long it is held [ns]. Decided: before somebody can have resized it. */
  private static final long HOLD_NANOS = 1_000_000_000;

  /** Frames for which it is held at least, on machines that are slow to open a window. */
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

  /** Holds the size of a window that has just been shown. */
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
