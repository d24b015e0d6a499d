package tellosimulator.view.layout;

import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Window;
import javafx.util.Subscription;

/**
 * Binds keys of a window to actions. Keys that can be typed into a text field are ignored while a
 * text field has the focus. A held key acts only once: showing or hiding a part of the window takes
 * longer than the system's repeat interval, so repeated actions would block the window. Confined to
 * the JavaFX thread.
 */
public final class KeyBindings {

  private final Map<WindowKey, Runnable> actions = new EnumMap<>(WindowKey.class);
  private final Set<KeyCode> held = EnumSet.noneOf(KeyCode.class);
  private boolean repeated;

  /** Binds a key to an action. */
  public KeyBindings on(WindowKey key, Runnable action) {
    actions.put(key, action);
    return this;
  }

  /** Returns the actions in the order of {@link WindowKey}. */
  Map<WindowKey, Runnable> actions() {
    return Collections.unmodifiableMap(actions);
  }

  /** Listens to the keys of a scene until the subscription ends. */
  public Subscription install(Scene scene) {
    EventHandler<KeyEvent> always =
        event -> {
          repeated = !held.add(event.getCode());
          act(event, key -> !key.writes());
        };
    EventHandler<KeyEvent> unlessTyping =
        event -> act(event, key -> key.writes() && !isTyping(scene));
    EventHandler<KeyEvent> released = event -> held.remove(event.getCode());
    Subscription unfocused =
        scene
            .windowProperty()
            .flatMap(Window::focusedProperty)
            .subscribe(focused -> held.clear()); // the releases went to another window
    scene.addEventFilter(KeyEvent.KEY_PRESSED, always);
    scene.addEventFilter(KeyEvent.KEY_RELEASED, released);
    scene.addEventHandler(KeyEvent.KEY_PRESSED, unlessTyping);
    return () -> {
      unfocused.unsubscribe();
      scene.removeEventFilter(KeyEvent.KEY_PRESSED, always);
      scene.removeEventFilter(KeyEvent.KEY_RELEASED, released);
      scene.removeEventHandler(KeyEvent.KEY_PRESSED, unlessTyping);
    };
  }

  private void act(KeyEvent event, Predicate<WindowKey> wanted) {
    for (WindowKey key : actions.keySet()) {
      if (wanted.test(key) && key.matches(event)) {
        event.consume();
        if (!repeated) {
          actions.get(key).run();
        }
        return;
      }
    }
  }

  private static boolean isTyping(Scene scene) {
    return scene.getFocusOwner() instanceof TextInputControl;
  }
}
