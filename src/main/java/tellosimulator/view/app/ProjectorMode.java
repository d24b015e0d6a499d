package tellosimulator.view.app;

import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.util.Subscription;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.layout.WindowState.Flag;

/**
 * Switches to full screen while the projector view is shown, and restores the previous full-screen
 * state afterwards. Confined to the JavaFX thread.
 */
final class ProjectorMode {

  private final WindowState state;
  private boolean fullScreenBefore;

  private ProjectorMode(WindowState state) {
    this.state = state;
  }

  /**
   * Follows {@link Flag#PROJECTOR} until the subscription ends. Esc in the scene clears the flag.
   */
  static Subscription install(Scene scene, WindowState state) {
    ProjectorMode mode = new ProjectorMode(state);
    EventHandler<KeyEvent> pressed = mode::pressed;
    scene.addEventHandler(KeyEvent.KEY_PRESSED, pressed);
    Subscription switched =
        state.flag(Flag.PROJECTOR).subscribe((before, now) -> mode.fillScreen(now));
    return switched.and(() -> scene.removeEventHandler(KeyEvent.KEY_PRESSED, pressed));
  }

  private void pressed(KeyEvent event) {
    if (event.getCode() == KeyCode.ESCAPE && state.flag(Flag.PROJECTOR).get()) {
      state.flag(Flag.PROJECTOR).set(false);
      event.consume();
    }
  }

  private void fillScreen(boolean projected) {
    if (projected) {
      fullScreenBefore = state.flag(Flag.FULL_SCREEN).get();
      state.flag(Flag.PLAN).set(false);
    }
    state.flag(Flag.FULL_SCREEN).set(projected || fullScreenBefore);
  }
}
