package tellosimulator.view.layout;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import tellosimulator.view.text.Messages;

/** The keys of the window, other than those that fly a drone. */
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
  SAVE_SCENARIO_AS(KeyCode.S, KeyCombination.SHORTCUT_DOWN, KeyCombination.SHIFT_DOWN),
  RELOAD_SCENARIO(KeyCombination.SHORTCUT_DOWN, KeyCode.R),
  AGAIN(KeyCombination.SHORTCUT_DOWN, KeyCode.N),
  NEXT_GROUP(KeyCode.N, KeyCombination.SHORTCUT_DOWN, KeyCombination.SHIFT_DOWN),
  SEARCH_LOG(KeyCombination.SHORTCUT_DOWN, KeyCode.F),
  COMMANDS(KeyCombination.SHORTCUT_DOWN, KeyCode.K),
  QUIT(KeyCombination.SHORTCUT_DOWN, KeyCode.Q);

  private final boolean withShortcut;
  private final boolean withShift;
  private final List<KeyCode> codes;
  private final List<KeyCombination> combinations;

  WindowKey(KeyCode... codes) {
    this.withShortcut = false;
    this.withShift = false;
    this.codes = List.of(codes);
    this.combinations =
        Arrays.stream(codes).map(code -> (KeyCombination) new KeyCodeCombination(code)).toList();
  }

  WindowKey(KeyCombination.Modifier modifier, KeyCode code) {
    this(code, modifier);
  }

  WindowKey(KeyCode code, KeyCombination.Modifier first, KeyCombination.Modifier... more) {
    KeyCombination.Modifier[] modifiers = Arrays.copyOf(more, more.length + 1);
    modifiers[more.length] = first;
    this.withShortcut = List.of(modifiers).contains(KeyCombination.SHORTCUT_DOWN);
    this.withShift = List.of(modifiers).contains(KeyCombination.SHIFT_DOWN);
    this.codes = List.of(code);
    this.combinations = List.of(new KeyCodeCombination(code, modifiers));
  }

  boolean matches(KeyEvent event) {
    return combinations.stream().anyMatch(combination -> combination.match(event));
  }

  /** Whether a text field could want it for itself. */
  boolean writes() {
    return !withShortcut && !codes.get(0).isFunctionKey();
  }

  /** Whether it only changes from where one looks, and at what. */
  boolean looks() {
    return compareTo(FRONT_VIEW) >= 0 && compareTo(PREVIOUS_DRONE) <= 0;
  }

  /** What is written on the keys, for people. */
  String symbols(Messages messages) {
    String shift = withShift ? messages.now("shift") + "+" : "";
    String prefix = shift + (withShortcut ? shortcut(messages) : "");
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

  /** What is written on the first of the keys, for people. */
  String symbol(Messages messages) {
    return symbol(codes.get(0), messages);
  }

  /** The key of the text that says what it does, in this package's messages. */
  String textKey() {
    return "key-" + name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
