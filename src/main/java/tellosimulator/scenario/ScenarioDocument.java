package tellosimulator.scenario;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.scenario.SyntaxTree.Collection;
import tellosimulator.scenario.SyntaxTree.Syntax;

/**
 * A scenario with the text that a person wrote of it. A change of the scenario changes only those
 * characters of the text that say something else; comments, order, empty lines, the spelling of
 * numbers and colours, and what is left out stay. Immutable; for any thread.
 */
public final class ScenarioDocument {

  /** How much of a text stayed when it was changed. */
  public enum Kept {
    /** All but what says something else. */
    ALL,
    /** The sections in which nothing changed; the others were written anew. */
    SECTIONS,
    /** Nothing. */
    NOTHING
  }

  private static final String BYTE_ORDER_MARK = "\uFEFF";

  private final Scenario scenario;
  private final Optional<String> text;
  private final Path folder;
  private final Kept kept;

  private ScenarioDocument(Scenario scenario, Optional<String> text, Path folder, Kept kept) {
    this.scenario = scenario;
    this.text = text;
    this.folder = folder;
    this.kept = kept;
  }

  /** Of a scenario that nobody has written yet. */
  public static ScenarioDocument of(Scenario scenario) {
    return new ScenarioDocument(scenario, Optional.empty(), Path.of(""), Kept.ALL);
  }

  /**
   * Of a text.
   *
   * @param text from which the scenario was read
   * @param folder in which it looks for pictures
   */
  static ScenarioDocument read(Scenario scenario, String text, Path folder) {
    return new ScenarioDocument(scenario, Optional.of(text), folder, Kept.ALL);
  }

  public Scenario scenario() {
    return scenario;
  }

  /** What there was of the text before, when it was last changed. */
  public Kept kept() {
    return kept;
  }

  /** The text in UTF-8; empty if there is none yet. */
  Optional<byte[]> bytes() {
    return text.map(written -> written.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * The same document with another scenario.
   *
   * @param newFolder in which its file will be
   */
  public ScenarioDocument changedTo(Scenario wanted, Path newFolder) {
    if (text.isEmpty()) {
      return written(wanted, newFolder);
    }
    boolean marked = text.get().startsWith(BYTE_ORDER_MARK);
    String mark = marked ? BYTE_ORDER_MARK : "";
    String old = text.get().substring(mark.length());
    Change change = new Change(old, wanted, newFolder);
    Optional<String> patched = change.patched();
    Kept patchKept = Kept.ALL;
    if (patched.isEmpty()) {
      patched = change.rewritten();
      patchKept = Kept.SECTIONS;
    }
    if (patched.isEmpty()) {
      return written(wanted, newFolder);
    }
    return new ScenarioDocument(wanted, Optional.of(mark + patched.get()), newFolder, patchKept);
  }

  private ScenarioDocument written(Scenario wanted, Path newFolder) {
    String whole = new ScenarioWriter(newFolder).text(wanted);
    Kept nothing = text.isEmpty() ? Kept.ALL : Kept.NOTHING;
    return new ScenarioDocument(wanted, Optional.of(whole), newFolder, nothing);
  }

  /** One change of the text, tried in several ways, of which each is checked. */
  private final class Change {

    private final String old;
    private final Scenario wanted;
    private final Path newFolder;
    private final Syntax syntax;
    private final Matching matching;
    private final Node before;
    private final List<Notation> notations;
    private final Node now;

    Change(String old, Scenario wanted, Path newFolder) {
      this.old = old;
      this.wanted = wanted;
      this.newFolder = newFolder;
      this.syntax = SyntaxTree.of(old);
      this.matching = Matching.of(scenario, wanted);
      List<Notation> oldNotations = Notations.read(scenario, syntax);
      this.before = new ScenarioWriter(folder).node(scenario, oldNotations);
      this.notations = Notations.kept(oldNotations, matching.of("obstacles"), wanted);
      this.now = new ScenarioWriter(newFolder).node(wanted, notations);
    }

    Optional<String> patched() {
      return new ScenarioPatch(old, matching).applied(before, now, syntax).filter(this::isRight);
    }

    /** With the sections written anew that differ. */
    Optional<String> rewritten() {
      Set<String> keys = ScenarioPatch.differing(before, now);
      return syntax instanceof Collection root
          ? new ScenarioPatch(old, matching).rewritten(keys, now, root).filter(this::isRight)
          : Optional.empty();
    }

    /** Whether a text says what is wanted. */
    private boolean isRight(String changed) {
      Optional<Scenario> read = ScenarioFile.understood(changed, newFolder);
      if (read.isEmpty()) {
        return false;
      }
      List<Notation> found = Notations.read(read.get(), SyntaxTree.of(changed));
      Node said = new ScenarioWriter(newFolder).node(read.get(), found);
      return ScenarioPatch.same(said, now)
          && Notations.gatesOfGoals(read.get()).equals(Notations.gatesOfGoals(wanted));
    }
  }
}
