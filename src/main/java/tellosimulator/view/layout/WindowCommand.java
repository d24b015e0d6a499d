package tellosimulator.view.layout;

import java.util.Locale;
import java.util.Optional;
import javafx.beans.value.ObservableValue;

/**
 * Something that the window can do, as its menu and its palette of commands offer it.
 *
 * @param group under which the menu has it
 * @param title what it is called; follows the language
 * @param aliases further words that find it, whatever the language is; may be empty
 * @param key the key that does the same, if there is one
 */
record WindowCommand(
    Group group,
    ObservableValue<String> title,
    String aliases,
    Optional<WindowKey> key,
    Runnable action) {

  /** The parts of the menu, in their order. */
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

    /** The key of its text, in this package's messages. */
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

  /** One that no key does. */
  static WindowCommand of(
      Group group, ObservableValue<String> title, String aliases, Runnable action) {
    return new WindowCommand(group, title, aliases, Optional.empty(), action);
  }

  /** What a key does. */
  static WindowCommand of(WindowKey key, ObservableValue<String> title, Runnable action) {
    String aliases = key.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    return new WindowCommand(Group.of(key), title, aliases, Optional.of(key), action);
  }

  /**
   * How well it fits what was typed: 0 if each word is one of its own, more for beginnings of words
   * and for parts of them.
   *
   * @param groupTitle what its group is called
   * @param words that were typed, in small letters
   * @return empty if one of the words is nowhere in it
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
