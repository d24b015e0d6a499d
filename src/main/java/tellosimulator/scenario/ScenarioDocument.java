package tellosimulator.scenario;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.scenario.ScenarioCodec.Noted;
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

  private final Noted noted;
  private final Optional<String> text;
  private final Path folder;
  private final Kept kept;

  private ScenarioDocument(Noted noted, Optional<String> text, Path folder, Kept kept) {
    this.noted = noted;
    this.text = text;
    this.folder = folder;
    this.kept = kept;
  }

  /** Of a scenario that nobody has written yet. */
  public static ScenarioDocument of(Scenario scenario) {
    return new ScenarioDocument(Noted.usual(scenario), Optional.empty(), Path.of(""), Kept.ALL);
  }

  /**
   * Of a text.
   *
   * @param noted what was read from it
   * @param folder in which it looks for pictures
   */
  static ScenarioDocument read(Noted noted, String text, Path folder) {
    return new ScenarioDocument(noted, Optional.of(text), folder, Kept.ALL);
  }

  Scenario scenario() {
    return noted.scenario();
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
    Optional<Changed> changed = change.patched();
    Kept patchKept = Kept.ALL;
    if (changed.isEmpty()) {
      changed = change.rewritten();
      patchKept = Kept.SECTIONS;
    }
    if (changed.isEmpty()) {
      return written(wanted, newFolder);
    }
    Optional<String> newText = Optional.of(mark + changed.get().text());
    return new ScenarioDocument(changed.get().noted(), newText, newFolder, patchKept);
  }

  private ScenarioDocument written(Scenario wanted, Path newFolder) {
    Noted usual = Noted.usual(wanted);
    String whole = Yaml.text(ScenarioCodec.CODEC.write(usual, newFolder));
    Kept nothing = text.isEmpty() ? Kept.ALL : Kept.NOTHING;
    return new ScenarioDocument(usual, Optional.of(whole), newFolder, nothing);
  }

  /** A text that says what is wanted, and how. */
  private record Changed(String text, Noted noted) {}

  /** One change of the text, tried in several ways, of which each is checked. */
  private final class Change {

    private final String old;
    private final Scenario wanted;
    private final Path newFolder;
    private final Syntax syntax;
    private final Matching matching;
    private final Node before;
    private final Node now;

    Change(String old, Scenario wanted, Path newFolder) {
      this.old = old;
      this.wanted = wanted;
      this.newFolder = newFolder;
      this.syntax = SyntaxTree.of(old);
      this.matching = Matching.of(noted.scenario(), wanted);
      this.before = ScenarioCodec.CODEC.write(noted, folder);
      List<Notation> notations = Notation.kept(noted.notations(), matching.of("obstacles"), wanted);
      this.now = ScenarioCodec.CODEC.write(new Noted(wanted, notations), newFolder);
    }

    Optional<Changed> patched() {
      return new ScenarioPatch(old, matching).applied(before, now, syntax).flatMap(this::checked);
    }

    /** With the sections written anew that differ. */
    Optional<Changed> rewritten() {
      Set<String> keys = ScenarioPatch.differing(before, now);
      return syntax instanceof Collection root
          ? new ScenarioPatch(old, matching).rewritten(keys, now, root).flatMap(this::checked)
          : Optional.empty();
    }

    /** A text if it says what is wanted. */
    private Optional<Changed> checked(String changed) {
      Optional<Noted> read =
          ScenarioFile.understood(changed, newFolder)
              .filter(said -> ScenarioPatch.same(ScenarioCodec.CODEC.write(said, newFolder), now))
              .filter(
                  said ->
                      Notation.gatesOfGoals(said.scenario()).equals(Notation.gatesOfGoals(wanted)));
      return read.map(said -> new Changed(changed, said.of(wanted)));
    }
  }
}
