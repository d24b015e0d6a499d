package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import tellosimulator.scenario.Diagnostic.Place;
import tellosimulator.words.Phrase;
import tellosimulator.words.Printable;

/** Collects the errors in a file. */
final class Diagnostics {

  /** Maximum number of errors that are kept. Decided: more than a user reads at once. */
  private static final int MOST = 100;

  private final String file;
  private final List<Diagnostic> found = new ArrayList<>();
  private int count;
  private int misfits;

  Diagnostics(String file) {
    this.file = file;
  }

  /** Adds an error, and returns empty, so that a reader can return this as its result. */
  <T> Optional<T> add(Node node, Phrase phrase) {
    add(place(node), () -> phrase);
    return Optional.empty();
  }

  /** Adds an error about an unexpected node, and returns empty. */
  <T> Optional<T> expected(Phrase expected, Node node) {
    return add(node, Phrase.of("expected %s, found %s", expected, found(node)));
  }

  void add(Place place, Phrase phrase) {
    add(place, () -> phrase);
  }

  /**
   * Adds an error. Once {@link #MOST} errors are stored, further errors are only counted, and their
   * phrases are not created.
   */
  void add(Place place, Supplier<Phrase> phrase) {
    count++;
    if (found.size() < MOST) {
      found.add(new Diagnostic(file, place, phrase.get()));
    }
  }

  /** Adds an error that another draw of the numbers in the file may avoid. */
  void misfit(Place place, Phrase phrase) {
    misfits++;
    add(place, phrase);
  }

  /** Whether there are errors, all of which another draw may avoid. */
  boolean mayFitAnotherTime() {
    return count > 0 && misfits == count;
  }

  /** Creates an exception that gives the first error as the reason why no course was found. */
  ScenarioException noCourse(int attempts, long seed) {
    Diagnostic last = found.get(0);
    Phrase phrase =
        Phrase.of(
            "none of %d courses drawn from seed %s fits; in the last one, %s",
            attempts, Long.toString(seed), last.phrase());
    return new ScenarioException(List.of(new Diagnostic(file, last.place(), phrase)));
  }

  /** Returns the number of errors so far, including those that were only counted. */
  int count() {
    return count;
  }

  /**
   * Throws an exception that lists the errors, sorted by position, if there are any.
   *
   * @throws ScenarioException if there are any errors
   */
  void check() throws ScenarioException {
    if (count == 0) {
      return;
    }
    List<Diagnostic> sorted = new ArrayList<>(found);
    sorted.sort(Comparator.comparing(Diagnostic::place));
    if (count > sorted.size()) {
      Place last = sorted.get(sorted.size() - 1).place();
      sorted.add(
          new Diagnostic(file, last, Phrase.of("and %d more mistakes", count - sorted.size())));
    }
    throw new ScenarioException(sorted);
  }

  /** Describes the content of a node for users, for example {@code "abc"}. */
  static Object found(Node node) {
    if (node instanceof MappingNode) {
      return Phrase.of("a mapping");
    }
    if (node instanceof SequenceNode sequence) {
      return Phrase.of("a list of %d", sequence.getValue().size());
    }
    ScalarNode scalar = (ScalarNode) node;
    return scalar.isPlain() && scalar.getValue().isEmpty()
        ? Phrase.of("nothing")
        : Printable.quoted(scalar.getValue());
  }

  static Place place(Node node) {
    return node.getStartMark().map(Diagnostics::place).orElse(Place.WHOLE);
  }

  static Place place(Mark mark) {
    return new Place(mark.getLine() + 1, mark.getColumn() + 1);
  }
}
