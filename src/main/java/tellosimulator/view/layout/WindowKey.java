package tellosimulator.view.layout;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.view.text.Messages;

/** The keys of the window, except for the keys that fly a drone. */
public enum WindowKey {
  HELP(KeyCode.F1),
  SIMULATOR_CONTROLS(KeyCode.F2),
  NETWORK_CONTROLS(KeyCode.F3),
  LOG(KeyCode.F4),
  DRONES(KeyCode.F5),
  INSET(KeyCode.F6),
  TRAIL(KeyCode.F7),
  GOAL_LINE(KeyCode.G),
  STILL(KeyCode.F8),
  PAUSE(KeyCode.F9),
  PLAN(KeyCode.F10),
  FULL_SCREEN(KeyCode.F11),
  PROJECTOR(KeyCombination.SHIFT_DOWN, KeyCode.F11),
  RECORD(KeyCode.F12),
  FRONT_VIEW(KeyCode.DIGIT1, KeyCode.NUMPAD1),
  SIDE_VIEW(KeyCode.DIGIT2, KeyCode.NUMPAD2),
  TOP_VIEW(KeyCode.DIGIT3, KeyCode.NUMPAD3),
  CHASE_VIEW(KeyCode.DIGIT4, KeyCode.NUMPAD4),
  DRONE_CAMERA(KeyCode.DIGIT5, KeyCode.NUMPAD5),
  FOLLOW(KeyCode.DIGIT6, KeyCode.NUMPAD6),
  FIT(KeyCode.DIGIT9, KeyCode.NUMPAD9, KeyCode.HOME),
  START_VIEW(KeyCode.DIGIT0, KeyCode.NUMPAD0),
  NEXT_DRONE(KeyCode.PAGE_DOWN),
  PREVIOUS_DRONE(KeyCode.PAGE_UP),
  GALLERY(KeyCombination.SHORTCUT_DOWN, KeyCode.G),
  OPEN_SCENARIO(KeyCombination.SHORTCUT_DOWN, KeyCode.O),
  SAVE_SCENARIO(KeyCombination.SHORTCUT_DOWN, KeyCode.S),
  SAVE_SCENARIO_AS(List.of(KeyCombination.SHORTCUT_DOWN, KeyCombination.SHIFT_DOWN), KeyCode.S),
  RELOAD_SCENARIO(KeyCombination.SHORTCUT_DOWN, KeyCode.R),
  AGAIN(KeyCombination.SHORTCUT_DOWN, KeyCode.N),
  NEXT_GROUP(List.of(KeyCombination.SHORTCUT_DOWN, KeyCombination.SHIFT_DOWN), KeyCode.N),
  SEARCH_LOG(KeyCombination.SHORTCUT_DOWN, KeyCode.F),
  COMMANDS(KeyCombination.SHORTCUT_DOWN, KeyCode.K),
  QUIT(KeyCombination.SHORTCUT_DOWN, KeyCode.Q);

  private final List<KeyCombination.Modifier> modifiers;
  private final List<KeyCode> codes;

  WindowKey(KeyCode... codes) {
    this(List.of(), codes);
  }

  WindowKey(KeyCombination.Modifier modifier, KeyCode code) {
    this(List.of(modifier), code);
  }

  WindowKey(List<KeyCombination.Modifier> modifiers, KeyCode... codes) {
    this.modifiers = modifiers;
    this.codes = List.of(codes);
  }

  /** Returns the key that selects a view. */
  public static WindowKey of(RoomView view) {
    return valueOf(view.name() + "_VIEW");
  }

  boolean matches(KeyEvent event) {
    KeyCombination.Modifier[] all = modifiers.toArray(KeyCombination.Modifier[]::new);
    return codes.stream().anyMatch(code -> new KeyCodeCombination(code, all).match(event));
  }

  /** Returns whether a text field could consume the key. */
  boolean writes() {
    return !modifiers.contains(KeyCombination.SHORTCUT_DOWN) && !codes.get(0).isFunctionKey();
  }

  /** Returns whether the key only changes the view or the selected drone. */
  boolean looks() {
    return compareTo(FRONT_VIEW) >= 0 && compareTo(PREVIOUS_DRONE) <= 0;
  }

  /** Returns the labels on the keys, as the window displays them. */
  String symbols(Messages messages) {
    String shift = modifiers.contains(KeyCombination.SHIFT_DOWN) ? messages.now("shift") + "+" : "";
    String prefix =
        shift + (modifiers.contains(KeyCombination.SHORTCUT_DOWN) ? shortcut(messages) : "");
    return codes.stream()
        .filter(code -> !code.isKeypadKey())
        .map(code -> prefix + symbol(code, messages))
        .collect(Collectors.joining(messages.now("or")));
  }

  private static String shortcut(Messages messages) {
    boolean mac = System.getProperty("os.name").toLowerCase(Locale.ROOT).contains("mac");
    return mac ? "⌘ " : messages.now("ctrl") + "+";
  }

  private static String symbol(KeyCode code, Messages messages) {
    return switch (code) {
      case HOME -> messages.now("home");
      case PAGE_DOWN -> messages.now("page-down");
      case PAGE_UP -> messages.now("page-up");
      default -> code.getName();
    };
  }

  /** Returns the label on the first key, as the window displays it. */
  String symbol(Messages messages) {
    return symbol(codes.get(0), messages);
  }

  /** Returns the key of the text that describes the action, in this package's messages. */
  String textKey() {
    return "key-" + name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
