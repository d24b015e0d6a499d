package tellosimulator.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import tellosimulator.words.Spelling;

/** The scenarios that come with the program. Thread-safe. */
public final class Gallery {

  /** The short names of all scenarios that come with the program, easiest first. */
  public static final List<String> NAMES =
      List.of(
          "empty-room",
          "over-the-wall",
          "slalom",
          "table-landing",
          "window-in-the-wall",
          "gate-race",
          "wind",
          "pad-course",
          "wall-pad",
          "swarm-stage");

  private Gallery() {}

  /** Returns the scenario with a short name; empty if there is none. */
  public static Optional<Scenario> find(String name) {
    return open(name).map(ScenarioDocument::scenario);
  }

  /**
   * Returns the document of the scenario with a short name, for editing and saving; empty if there
   * is none.
   */
  public static Optional<ScenarioDocument> open(String name) {
    return NAMES.contains(name) ? Optional.of(read(name)) : Optional.empty();
  }

  /** Translates the English name of a scenario; unknown names are returned unchanged. */
  public static String nameIn(String english, Locale locale) {
    return NAMES.stream()
        .map(name -> read(name).scenario().description().name())
        .filter(name -> name.english().equals(english))
        .findFirst()
        .map(name -> name.in(locale))
        .orElse(english);
  }

  /**
   * Returns the short name that follows the given one in {@link #NAMES}; empty after the last one.
   */
  public static Optional<String> next(String name) {
    return NAMES.stream().skip(NAMES.indexOf(name) + 1L).findFirst();
  }

  /** Returns the short name most similar to a misspelled one; empty if none is similar. */
  static Optional<String> meant(String name) {
    return Spelling.meant(name, NAMES);
  }

  private static ScenarioDocument read(String name) {
    try (InputStream input = Gallery.class.getResourceAsStream(name + ".yaml")) {
      return ScenarioFile.open(name + ".yaml", input);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (ScenarioException e) {
      throw new IllegalStateException(e);
    }
  }
}
