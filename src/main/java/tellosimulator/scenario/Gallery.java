package tellosimulator.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import tellosimulator.words.Spelling;

/** The scenarios that come with the program. For any thread. */
public final class Gallery {

  /** Their short names, the easiest first. */
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

  /** The one of a short name, if there is such a one. */
  public static Optional<Scenario> find(String name) {
    return open(name).map(ScenarioDocument::scenario);
  }

  /** The same, to change and to save it. */
  public static Optional<ScenarioDocument> open(String name) {
    return NAMES.contains(name) ? Optional.of(read(name)) : Optional.empty();
  }

  /** What a scenario is called in a language whose English name is known; that name if unknown. */
  public static String nameIn(String english, Locale locale) {
    return NAMES.stream()
        .map(name -> read(name).scenario().description().name())
        .filter(name -> name.english().equals(english))
        .findFirst()
        .map(name -> name.in(locale))
        .orElse(english);
  }

  /** The short name of the one after a scenario; empty after the last. */
  public static Optional<String> next(String name) {
    return NAMES.stream().skip(NAMES.indexOf(name) + 1L).findFirst();
  }

  /** The name that was meant. */
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
