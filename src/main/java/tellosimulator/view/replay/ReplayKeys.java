package tellosimulator.view.replay;

import java.util.EnumMap;
import java.util.Map;
import javafx.event.EventHandler;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.ComboBoxBase;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.util.Subscription;

/**
 * The keys of the player. They act wherever the focus is, but for Space, which presses a button
 * that was reached by the keyboard. For the JavaFX thread.
 */
final class ReplayKeys {

  private final Map<KeyCode, Runnable> actions = new EnumMap<>(KeyCode.class);
  private final Map<KeyCode, Runnable> shifted = new EnumMap<>(KeyCode.class);
  private boolean spaceHeld;

  /** Lets a key do something, again and again while it is held. */
  ReplayKeys on(KeyCode key, Runnable action) {
    actions.put(key, action);
    return this;
  }

  /** Lets a key do something else while Shift is held. */
  ReplayKeys onShift(KeyCode key, Runnable action) {
    shifted.put(key, action);
    return this;
  }

  /** Listens to the keys of a scene until the subscription ends. */
  Subscription install(Scene scene) {
    EventHandler<KeyEvent> pressed = event -> press(event, scene.getFocusOwner());
    EventHandler<KeyEvent> released =
        event -> spaceHeld &= event.getCode() != KeyCode.SPACE; // it repeats while it is held
    scene.addEventFilter(KeyEvent.KEY_PRESSED, pressed);
    scene.addEventFilter(KeyEvent.KEY_RELEASED, released);
    return () -> {
      scene.removeEventFilter(KeyEvent.KEY_PRESSED, pressed);
      scene.removeEventFilter(KeyEvent.KEY_RELEASED, released);
    };
  }

  private void press(KeyEvent event, Node focused) {
    boolean space = event.getCode() == KeyCode.SPACE;
    Runnable action = (event.isShiftDown() ? shifted : actions).get(event.getCode());
    boolean other = event.isControlDown() || event.isAltDown() || event.isMetaDown();
    if (action == null || other || (space && presses(focused))) {
      return;
    }
    event.consume();
    boolean repeated = space && spaceHeld;
    spaceHeld |= space;
    if (!repeated) {
      action.run();
    }
  }

  /** Whether Space does something to what has the focus, and a person can see that it has. */
  private static boolean presses(Node focused) {
    boolean takesSpace =
        focused instanceof ButtonBase
            || focused instanceof ComboBoxBase
            || focused instanceof ChoiceBox;
    return takesSpace && focused.isFocusVisible();
  }
}
