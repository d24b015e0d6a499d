package tellosimulator.view.app;

import javafx.collections.ListChangeListener;
import javafx.event.EventHandler;
import javafx.scene.input.InputEvent;
import javafx.stage.Window;
import javafx.util.Subscription;

/**
 * Notifies a listener of all input events in all windows of the program, before they are handled.
 * Popup menus and lists are included, because they are windows of their own. Confined to the JavaFX
 * thread.
 */
final class InputActivity {

  private InputActivity() {}

  /** Notifies the listener of each input event until the subscription ends. */
  static Subscription subscribe(Runnable listener) {
    EventHandler<InputEvent> telling = input -> listener.run();
    ListChangeListener<Window> windows =
        change -> {
          while (change.next()) {
            change.getRemoved().forEach(gone -> gone.removeEventFilter(InputEvent.ANY, telling));
            change
                .getAddedSubList()
                .forEach(shown -> shown.addEventFilter(InputEvent.ANY, telling));
          }
        };
    Window.getWindows().forEach(shown -> shown.addEventFilter(InputEvent.ANY, telling));
    Window.getWindows().addListener(windows);
    return () -> {
      Window.getWindows().removeListener(windows);
      Window.getWindows().forEach(shown -> shown.removeEventFilter(InputEvent.ANY, telling));
    };
  }
}
