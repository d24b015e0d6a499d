package tellosimulator.view.layout;

import java.util.Locale;
import java.util.Optional;
import javafx.beans.value.ObservableValue;

/**
 * A command of the window. The command menu and the command palette offer it.
 *
 * @param group the command's group in the menu
 * @param title the displayed name; follows the language
 * @param aliases additional words that find the command in any language; may be empty
 * @param key the key that runs the command; empty if there is none
 */
record WindowCommand(
    Group group,
    ObservableValue<String> title,
    String aliases,
    Optional<WindowKey> key,
    Runnable action) {

  /** The groups of the menu, in the displayed order. */
  enum Group {
    SCENARIO,
    DRONE,
    TIME,
    WIND,
    FAULTS,
    RECORDING,
    VIEW,
    WINDOW,
    THEME,
    LANGUAGE;

    /** Returns the key of the group's text in this package's messages. */
    String textKey() {
      return "group-" + name().toLowerCase(Locale.ROOT);
    }

    private static Group of(WindowKey key) {
      if (key.looks()) {
        return VIEW;
      }
      return switch (key) {
        case OPEN_SCENARIO, SAVE_SCENARIO, SAVE_SCENARIO_AS, RELOAD_SCENARIO, AGAIN -> SCENARIO;
        case PAUSE -> TIME;
        case STILL, RECORD -> RECORDING;
        default -> WINDOW;
      };
    }
  }

  /** Returns a command that has no key. */
  static WindowCommand of(
      Group group, ObservableValue<String> title, String aliases, Runnable action) {
    return new WindowCommand(group, title, aliases, Optional.empty(), action);
  }

  /** Returns the command that a key runs. */
  static WindowCommand of(WindowKey key, ObservableValue<String> title, Runnable action) {
    String aliases = key.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    return new WindowCommand(Group.of(key), title, aliases, Optional.of(key), action);
  }

  /**
   * Ranks how well the command matches the typed words. The rank is 0 if each typed word is a word
   * of the command, and higher for prefixes and substrings.
   *
   * @param groupTitle the displayed name of the group
   * @param words the typed words in lower case
   * @return empty if one of the words does not occur
   */
  Optional<Integer> rank(String groupTitle, String... words) {
    String text = String.join(" ", title.getValue(), aliases, groupTitle).toLowerCase(Locale.ROOT);
    String spaced = " " + text.replaceAll("[^\\p{L}\\p{N}.,%]+", " ") + " ";
    int rank = 0;
    for (String word : words) {
      if (spaced.contains(" " + word + " ")) {
        continue;
      }
      if (spaced.contains(" " + word)) {
        rank += 1;
      } else if (text.contains(word)) {
        rank += 3;
      } else {
        return Optional.empty();
      }
    }
    return Optional.of(rank);
  }
}
