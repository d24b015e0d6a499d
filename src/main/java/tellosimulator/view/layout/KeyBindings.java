package tellosimulator.view.layout;

import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Window;
import javafx.util.Subscription;

/**
 * Binds keys of a window to actions. Keys that could be typed into a text field do nothing while
 * one has the focus. A key that is held acts once, although the system repeats it: to show and hide
 * something takes longer than from one repetition to the next, so that the window would do nothing
 * else any more. For the JavaFX thread.
 */
public final class KeyBindings {

  private final Map<WindowKey, Runnable> actions = new EnumMap<>(WindowKey.class);
  private final Set<KeyCode> held = EnumSet.noneOf(KeyCode.class);
  private boolean repeated;

  /** Lets a key do something. */
  public KeyBindings on(WindowKey key, Runnable action) {
    actions.put(key, action);
    return this;
  }

  /** What keys do, in the order of the keys. */
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
            .subscribe(focused -> held.clear()); // releases went elsewhere
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
    Consumer<Runnable> run =
        action -> {
          event.consume();
          if (!repeated) {
            action.run();
          }
        };
    actions.keySet().stream()
        .filter(wanted)
        .filter(key -> key.matches(event))
        .findFirst()
        .map(actions::get)
        .ifPresent(run);
  }

  private static boolean isTyping(Scene scene) {
    return scene.getFocusOwner() instanceof TextInputControl;
  }
}
