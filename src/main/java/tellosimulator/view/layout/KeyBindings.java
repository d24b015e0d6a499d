package tellosimulator.view.layout;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyEvent;
import javafx.util.Subscription;

/**
 * Binds keys of a window to actions. Keys that could be typed into a text field do nothing while
 * one has the focus. For the JavaFX thread.
 */
public final class KeyBindings {

  private final Map<WindowKey, Runnable> actions = new EnumMap<>(WindowKey.class);

  /** Lets a key do something. */
  public KeyBindings on(WindowKey key, Runnable action) {
    actions.put(key, action);
    return this;
  }

  /** Listens to the keys of a scene until the subscription ends. */
  public Subscription install(Scene scene) {
    EventHandler<KeyEvent> always = event -> act(event, key -> !key.writes());
    EventHandler<KeyEvent> unlessTyping =
        event -> act(event, key -> key.writes() && !isTyping(scene));
    scene.addEventFilter(KeyEvent.KEY_PRESSED, always);
    scene.addEventHandler(KeyEvent.KEY_PRESSED, unlessTyping);
    return () -> {
      scene.removeEventFilter(KeyEvent.KEY_PRESSED, always);
      scene.removeEventHandler(KeyEvent.KEY_PRESSED, unlessTyping);
    };
  }

  private void act(KeyEvent event, Predicate<WindowKey> wanted) {
    Consumer<Runnable> run =
        action -> {
          event.consume();
          action.run();
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
