package tellosimulator.view.replay;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import javafx.event.EventHandler;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.ComboBoxBase;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import javafx.util.Subscription;

/**
 * The player's keyboard shortcuts. They work regardless of the focus, except that Space presses a
 * button that was focused with the keyboard. Confined to the JavaFX thread.
 */
final class ReplayKeys {

  private final Map<KeyCombination, Runnable> actions = new HashMap<>();
  private boolean spaceHeld;

  /** Adds a shortcut, which repeats while the key is held, unless the key is Space. */
  ReplayKeys on(KeyCode key, Runnable action, KeyCombination.Modifier... modifiers) {
    actions.put(new KeyCodeCombination(key, modifiers), action);
    return this;
  }

  /** Handles the keys of a scene until the subscription ends. */
  Subscription install(Scene scene) {
    EventHandler<KeyEvent> pressed = event -> press(event, scene.getFocusOwner());
    EventHandler<KeyEvent> released =
        event -> spaceHeld &= event.getCode() != KeyCode.SPACE; // Space must not repeat while held
    scene.addEventFilter(KeyEvent.KEY_PRESSED, pressed);
    scene.addEventFilter(KeyEvent.KEY_RELEASED, released);
    return () -> {
      scene.removeEventFilter(KeyEvent.KEY_PRESSED, pressed);
      scene.removeEventFilter(KeyEvent.KEY_RELEASED, released);
    };
  }

  private void press(KeyEvent event, Node focused) {
    boolean space = event.getCode() == KeyCode.SPACE;
    Optional<KeyCombination> key =
        actions.keySet().stream().filter(known -> known.match(event)).findFirst();
    if (key.isEmpty() || (space && presses(focused))) {
      return;
    }
    event.consume();
    boolean repeated = space && spaceHeld;
    spaceHeld |= space;
    if (!repeated) {
      actions.get(key.get()).run();
    }
  }

  /** Returns whether the focused control reacts to Space and shows a focus ring. */
  private static boolean presses(Node focused) {
    boolean takesSpace =
        focused instanceof ButtonBase
            || focused instanceof ComboBoxBase
            || focused instanceof ChoiceBox;
    return takesSpace && focused.isFocusVisible();
  }
}
