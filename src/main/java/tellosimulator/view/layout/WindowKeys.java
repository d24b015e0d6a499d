package tellosimulator.view.layout;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.scene.Scene;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyEvent;

/**
 * What the keys of a window do. Those that could be typed into a text field do nothing while one
 * has the focus. For the JavaFX thread.
 */
public final class WindowKeys {

  private final Map<WindowKey, Runnable> actions = new EnumMap<>(WindowKey.class);

  /** Lets a key do something. */
  public WindowKeys on(WindowKey key, Runnable action) {
    actions.put(key, action);
    return this;
  }

  /** Listens to the keys of a window from now on. */
  public void install(Scene scene) {
    scene.addEventFilter(KeyEvent.KEY_PRESSED, event -> act(event, key -> !key.writes()));
    scene.addEventHandler(
        KeyEvent.KEY_PRESSED, event -> act(event, key -> key.writes() && !isTyping(scene)));
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
