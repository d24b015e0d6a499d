package tellosimulator.scenario;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.goal.Goal;
import tellosimulator.scenario.ScenarioCodec.ParsedScenario;
import tellosimulator.world.Obstacle;

/**
 * A scenario together with the text that a user wrote. Where possible, a change to the scenario
 * changes only the affected list items and top-level entries of the text. All others are preserved,
 * with the comments and empty lines between them. Each new text is read again to verify it.
 * Immutable.
 */
public final class ScenarioDocument {

  /** The extent to which a change preserved the text. */
  public enum Preserved {
    /** Everything was preserved except the list items and top-level entries that differ. */
    ALL,
    /** The top-level entries without changes were preserved; the codec wrote all others. */
    SECTIONS,
    NOTHING
  }

  private static final String BYTE_ORDER_MARK = "\uFEFF";

  private final ParsedScenario noted;
  private final Optional<String> text;
  private final Path folder;
  private final Preserved kept;
  private final CourseDraw draw;

  private ScenarioDocument(
      ParsedScenario noted, Optional<String> text, Path folder, Preserved kept, CourseDraw draw) {
    this.noted = noted;
    this.text = text;
    this.folder = folder;
    this.kept = kept;
    this.draw = draw;
  }

  /** Creates a document for a scenario that has no text yet. */
  public static ScenarioDocument of(Scenario scenario) {
    return new ScenarioDocument(
        ParsedScenario.usual(scenario),
        Optional.empty(),
        Path.of(""),
        Preserved.ALL,
        CourseDraw.NONE);
  }

  /**
   * Creates a document for a text.
   *
   * @param noted the scenario that was read from the text
   * @param folder the folder to which the names of image files are relative
   * @param draw the random numbers for the ranges in the text
   */
  static ScenarioDocument read(ParsedScenario noted, String text, Path folder, CourseDraw draw) {
    return new ScenarioDocument(noted, Optional.of(text), folder, Preserved.ALL, draw);
  }

  /** Returns whether the text contained ranges when it was read. */
  boolean varies() {
    return !draw.isEmpty();
  }

  /** Returns the text as it was read, with numbers in the places of its ranges. */
  String drawnText() {
    return draw.textOf(text.orElseThrow());
  }

  /**
   * Returns this document with the course of another seed.
   *
   * @param name the name of the file in messages
   * @throws ScenarioException if no course of this seed fits
   */
  ScenarioDocument drawnFrom(long seed, String name) throws ScenarioException {
    return ScenarioFile.open(name, bytes().orElseThrow(), folder, OptionalLong.of(seed));
  }

  Scenario scenario() {
    return noted.scenario();
  }

  /** Returns how much of the text was preserved by the latest change. */
  public Preserved kept() {
    return kept;
  }

  /** Returns the text in UTF-8; empty if there is none yet. */
  Optional<byte[]> bytes() {
    return text.map(written -> written.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Returns a copy of this document with another scenario. The text changes as little as possible;
   * {@link #kept} returns how much of it was preserved.
   *
   * @param newFolder the folder that will contain the file
   */
  public ScenarioDocument changedTo(Scenario wanted, Path newFolder) {
    return patched(wanted, newFolder, false, Preserved.ALL)
        .or(() -> patched(wanted, newFolder, true, Preserved.ALL))
        .or(() -> patched(wanted, newFolder, true, Preserved.SECTIONS))
        .orElseGet(() -> written(wanted, newFolder));
  }

  /**
   * Returns a copy of this document with a changed text; empty if reading the text does not give
   * the wanted scenario.
   *
   * @param gatesNamed whether the text contains the names of all gates
   */
  private Optional<ScenarioDocument> patched(
      Scenario wanted, Path newFolder, boolean gatesNamed, Preserved preserved) {
    String all = text.orElse("");
    String mark = all.startsWith(BYTE_ORDER_MARK) ? BYTE_ORDER_MARK : "";
    List<Integer> matches = ScenarioPatch.matches(names(scenario()), names(wanted));
    ParsedScenario target =
        new ParsedScenario(wanted, SourceForm.kept(noted, matches, wanted, gatesNamed));
    Node now = ScenarioCodec.CODEC.write(target, newFolder);
    ScenarioPatch patch = new ScenarioPatch(ScenarioCodec.CODEC.write(noted, folder), now, matches);
    Optional<String> changed =
        text.flatMap(
            old -> patch.applied(old.substring(mark.length()), preserved == Preserved.ALL));
    return changed
        .flatMap(newText -> ScenarioFile.understood(newText, newFolder, draw))
        .filter(read -> ScenarioPatch.same(ScenarioCodec.CODEC.write(read, newFolder), now))
        .filter(read -> gatesOfGoals(read.scenario()).equals(gatesOfGoals(wanted)))
        .map(
            read ->
                new ScenarioDocument(
                    target, changed.map(mark::concat), newFolder, preserved, draw));
  }

  private static List<String> names(Scenario scenario) {
    return scenario.config().arena().obstacles().stream().map(Obstacle::name).toList();
  }

  /**
   * For each goal that requires flying through a gate, returns the index of the gate among the
   * obstacles; -1 if there is no such gate.
   */
  private static List<Integer> gatesOfGoals(Scenario scenario) {
    return scenario.challenge().goals().stream()
        .filter(Goal.Pass.class::isInstance)
        .map(goal -> names(scenario).indexOf(((Goal.Pass) goal).gate()))
        .toList();
  }

  private ScenarioDocument written(Scenario wanted, Path newFolder) {
    ParsedScenario usual = ParsedScenario.usual(wanted);
    String whole = ScenarioPatch.text(ScenarioCodec.CODEC.write(usual, newFolder));
    Preserved nothing = text.isEmpty() ? Preserved.ALL : Preserved.NOTHING;
    return new ScenarioDocument(usual, Optional.of(whole), newFolder, nothing, CourseDraw.NONE);
  }
}
