package tellosimulator.view;

import javafx.collections.ListChangeListener;
import javafx.event.EventHandler;
import javafx.scene.input.InputEvent;
import javafx.stage.Window;
import javafx.util.Subscription;

/**
 * Tells of all input before it is taken, in whatever window of the program: menus and lists that
 * pop up are windows of their own. For the JavaFX thread.
 */
final class AnyInput {

  private AnyInput() {}

  /** Tells somebody until the subscription ends. */
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
