package tellosimulator.view.app;

import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.util.Subscription;
import tellosimulator.view.layout.WindowState;

/** Fills the screen with the projector view, and leaves it as it was. For the JavaFX thread. */
final class ProjectorMode {

  private final WindowState state;
  private boolean fullScreenBefore;

  private ProjectorMode(WindowState state) {
    this.state = state;
  }

  /** Follows a window's state, and lets Esc in its scene end the view, until it ends. */
  static Subscription install(Scene scene, WindowState state) {
    ProjectorMode mode = new ProjectorMode(state);
    EventHandler<KeyEvent> pressed = mode::pressed;
    scene.addEventHandler(KeyEvent.KEY_PRESSED, pressed);
    Subscription switched =
        state.projectorProperty().subscribe((before, now) -> mode.fillScreen(now));
    return switched.and(() -> scene.removeEventHandler(KeyEvent.KEY_PRESSED, pressed));
  }

  private void pressed(KeyEvent event) {
    if (event.getCode() == KeyCode.ESCAPE && state.projectorProperty().get()) {
      state.projectorProperty().set(false);
      event.consume();
    }
  }

  private void fillScreen(boolean projected) {
    if (projected) {
      fullScreenBefore = state.fullScreenProperty().get();
      state.planShownProperty().set(false);
    }
    state.fullScreenProperty().set(projected || fullScreenBefore);
  }
}
