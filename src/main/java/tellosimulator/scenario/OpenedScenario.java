package tellosimulator.scenario;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.UnaryOperator;
import tellosimulator.sim.SimConfig;

/**
 * A scenario together with its source, from which it can be opened again. Immutable.
 *
 * @param document the document as it was read or last saved
 * @param scenario the document's scenario, changed by the options that apply to all scenarios
 * @param file the file from which the document was read; empty if it was not read from a file
 * @param known the scenario's short name in the gallery; empty if it is not in the gallery
 */
public record OpenedScenario(
    ScenarioDocument document, Scenario scenario, Optional<Path> file, Optional<String> known) {

  /** Returns a copy that has another scenario and the same source. */
  public OpenedScenario with(Scenario changed) {
    return new OpenedScenario(document, changed, file, known);
  }

  /** Creates an opened scenario that has no source, and thus cannot be opened again. */
  public static OpenedScenario once(Scenario scenario) {
    return new OpenedScenario(
        ScenarioDocument.of(scenario), scenario, Optional.empty(), Optional.empty());
  }

  /**
   * Opens a scenario, given the name of a file or of a scenario that comes with the program. A file
   * takes precedence.
   *
   * @throws ScenarioException if the file cannot be read or contains errors
   * @throws IllegalArgumentException if there is neither such a file nor such a scenario; the
   *     message is one sentence
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

  /** Returns whether the file contains ranges, so that each seed gives another course. */
  public boolean varies() {
    return document.varies();
  }

  /**
   * Returns this scenario, without options, with another seed and the course drawn from it. A
   * scenario without ranges is returned unchanged.
   *
   * @throws ScenarioException if no course of this seed fits
   */
  public OpenedScenario drawnFrom(long seed) throws ScenarioException {
    if (!varies()) {
      return this;
    }
    String name = file.map(Path::toString).or(() -> known).orElse("");
    ScenarioDocument drawn = document.drawnFrom(seed, name);
    SimConfig config = drawn.scenario().config().withSeed(seed);
    return new OpenedScenario(drawn, drawn.scenario().withConfig(config), file, known);
  }

  /**
   * Returns this scenario with rules for all scenarios applied, and its course drawn from a seed.
   *
   * @param rules applies the command-line options; throws an {@link IllegalArgumentException} with
   *     a message for the user if they do not fit the scenario
   * @param seed the seed of the course; if empty, that of the rules or of the scenario
   * @throws ScenarioException if no course of this seed fits
   */
  public OpenedScenario under(UnaryOperator<Scenario> rules, OptionalLong seed)
      throws ScenarioException {
    Scenario plain = rules.apply(scenario);
    if (!varies()) {
      return with(plain);
    }
    long drawnFrom = seed.orElse(plain.config().seed());
    OpenedScenario course = drawnFrom(drawnFrom);
    Scenario changed = rules.apply(course.scenario);
    return course.with(changed.withConfig(changed.config().withSeed(drawnFrom)));
  }

  /**
   * Returns the English name of the scenario, or else the name of its file, or else its short name
   * in the gallery; may be empty.
   */
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

  /** Creates an opened scenario that was read from a file. */
  public static OpenedScenario of(ScenarioDocument document, Path file) {
    return new OpenedScenario(document, document.scenario(), Optional.of(file), Optional.empty());
  }

  /** Creates an opened scenario that comes with the program. */
  public static OpenedScenario known(ScenarioDocument document, String name) {
    return new OpenedScenario(document, document.scenario(), Optional.empty(), Optional.of(name));
  }

  /**
   * Opens a scenario that was sent from another machine.
   *
   * @param name the name of the file there, for messages
   * @throws ScenarioException if it contains errors
   * @throws IllegalArgumentException if it has pictures, which are files of this machine; the
   *     message is one sentence
   */
  public static OpenedScenario received(String name, byte[] bytes) throws ScenarioException {
    ScenarioDocument document = ScenarioFile.open(name, bytes, Path.of(""), OptionalLong.empty());
    Scenario scenario = document.scenario();
    if (scenario.config().arena().pictures().findAny().isPresent()) {
      throw new IllegalArgumentException(
          name + " has pictures, which cannot be sent: remove them, or begin with --scenario");
    }
    return new OpenedScenario(document, scenario, Optional.empty(), Optional.empty());
  }
}
