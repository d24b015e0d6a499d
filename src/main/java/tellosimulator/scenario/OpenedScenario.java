package tellosimulator.scenario;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.world.Arena;
import tellosimulator.world.Decor;

/**
 * A scenario, and how to open and save it again. Immutable.
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
   * @throws ScenarioException if the file cannot be read, or has mistakes
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

  /**
   * What is to be saved: what has changed since it was opened, and the rest as the document has it,
   * so that no option gets into a file.
   *
   * @param present with as many drones
   */
  public Scenario toSave(Scenario present) {
    SimConfig written = document.scenario().config();
    SimConfig opened = scenario.config();
    SimConfig now = present.config();
    List<DroneSetup> drones = new ArrayList<>();
    for (int i = 0; i < now.drones().size(); i++) {
      drones.add(changed(written.drones().get(i), opened.drones().get(i), now.drones().get(i)));
    }
    Arena arena = changed(written.arena(), opened.arena(), now.arena());
    return document.scenario().withConfig(written.withArena(arena).withDrones(drones));
  }

  private static DroneSetup changed(DroneSetup written, DroneSetup opened, DroneSetup now) {
    return written
        .withStart(changed(written.start(), opened.start(), now.start()))
        .withProduct(changed(written.product(), opened.product(), now.product()))
        .withOutlets(changed(written.outlets(), opened.outlets(), now.outlets()));
  }

  private static Arena changed(Arena written, Arena opened, Arena now) {
    Decor decor = written.decor();
    Decor was = opened.decor();
    Decor is = now.decor();
    return new Arena(
        changed(written.room(), opened.room(), now.room()),
        new Decor(
            changed(decor.grid(), was.grid(), is.grid()),
            changed(decor.walls(), was.walls(), is.walls()),
            changed(decor.posters(), was.posters(), is.posters())),
        changed(written.obstacles(), opened.obstacles(), now.obstacles()),
        changed(written.pads(), opened.pads(), now.pads()),
        changed(written.wind(), opened.wind(), now.wind()));
  }

  private static <T> T changed(T written, T opened, T now) {
    return now.equals(opened) ? written : now;
  }

  /**
   * Whether saving would change something. In a room that nobody opened only what was placed there
   * counts: nobody saves a room for its size.
   */
  public boolean unsaved(Scenario present) {
    if (file.isPresent() || known.isPresent()) {
      return !toSave(present).equals(document.scenario());
    }
    Arena was = document.scenario().config().arena();
    Arena is = present.config().arena();
    return !is.obstacles().equals(was.obstacles()) || !is.pads().equals(was.pads());
  }
}
