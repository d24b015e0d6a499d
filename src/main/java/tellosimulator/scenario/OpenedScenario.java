package tellosimulator.scenario;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A scenario, and how to open it again. Immutable.
 *
 * @param document as it was read or last saved
 * @param scenario the same with what options say about all scenarios
 * @param file from which it came
 * @param known its short name among those that come with the program
 */
public record OpenedScenario(
    ScenarioDocument document, Scenario scenario, Optional<Path> file, Optional<String> known) {

  /** The same with another scenario made of it. */
  public OpenedScenario with(Scenario changed) {
    return new OpenedScenario(document, changed, file, known);
  }

  /** One that cannot be opened again. */
  public static OpenedScenario once(Scenario scenario) {
    return new OpenedScenario(
        ScenarioDocument.of(scenario), scenario, Optional.empty(), Optional.empty());
  }

  /**
   * One that somebody names: a file, or one of those that come with the program. A file counts more
   * than one of the program that has the same name.
   *
   * @throws ScenarioException if the file cannot be read, or has diagnostics
   * @throws IllegalArgumentException with a sentence, if there is neither
   */
  public static OpenedScenario named(String fileOrName) throws ScenarioException {
    Optional<Path> file = path(fileOrName);
    Optional<ScenarioDocument> known = Gallery.open(fileOrName);
    boolean looksLikeFile = fileOrName.matches(".*([./\\\\]).*");
    if (file.filter(Files::exists).isPresent()
        || (file.isPresent() && known.isEmpty() && looksLikeFile)) {
      return of(ScenarioFile.open(file.get()), file.get());
    }
    return known
        .map(document -> known(document, fileOrName))
        .orElseThrow(() -> new IllegalArgumentException(unknown(fileOrName)));
  }

  /** Its name in English, or that of its file; may be empty. */
  public String title() {
    LocalizedText name = scenario.description().name();
    return name.isEmpty()
        ? file.map(path -> String.valueOf(path.getFileName())).or(() -> known).orElse("")
        : name.english();
  }

  private static Optional<Path> path(String word) {
    try {
      return Optional.of(Path.of(word));
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private static String unknown(String word) {
    String guess =
        Gallery.meant(word)
            .map(name -> ", did you mean " + name + "?")
            .orElse("; there are " + String.join(", ", Gallery.NAMES));
    return "there is neither a file nor a scenario " + word + guess;
  }

  /** One of a file. */
  public static OpenedScenario of(ScenarioDocument document, Path file) {
    return new OpenedScenario(document, document.scenario(), Optional.of(file), Optional.empty());
  }

  /** One that comes with the program. */
  public static OpenedScenario known(ScenarioDocument document, String name) {
    return new OpenedScenario(document, document.scenario(), Optional.empty(), Optional.of(name));
  }
}
