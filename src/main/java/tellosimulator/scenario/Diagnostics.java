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

/** Collects what is wrong in a file. */
final class Diagnostics {

  /** More than anybody reads at once. Decided. */
  private static final int MOST = 100;

  /** Longest piece of a file that is repeated in a sentence [characters]. */
  private static final int LONGEST_SHOWN = 40;

  private final String file;
  private final List<Diagnostic> found = new ArrayList<>();
  private int count;

  Diagnostics(String file) {
    this.file = file;
  }

  /** Empty, for who cannot go on. */
  <T> Optional<T> add(Node node, Phrase phrase) {
    add(place(node), () -> phrase);
    return Optional.empty();
  }

  /** A node is not what is expected; empty, for who cannot go on. */
  <T> Optional<T> expected(Phrase expected, Node node) {
    return add(node, Phrase.of("expected %s, found %s", expected, found(node)));
  }

  void add(Place place, Phrase phrase) {
    add(place, () -> phrase);
  }

  /** Beyond the most that are kept, the phrase is not made. */
  void add(Place place, Supplier<Phrase> phrase) {
    count++;
    if (found.size() < MOST) {
      found.add(new Diagnostic(file, place, phrase.get()));
    }
  }

  /** How many there are so far. */
  int count() {
    return count;
  }

  /**
   * In the order of their places.
   *
   * @throws ScenarioException if there are any
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

  /** What is in a node, for people: {@code "abc"}. */
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
        : shown(scalar.getValue());
  }

  /** A piece of a file in quotation marks. */
  static String shown(String text) {
    String clean =
        text.codePoints()
            .map(c -> Character.isISOControl(c) ? ' ' : c)
            .limit(LONGEST_SHOWN)
            .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
            .toString();
    return "\"" + clean + (clean.length() < text.length() ? "…" : "") + "\"";
  }

  static Place place(Node node) {
    return node.getStartMark().map(Diagnostics::place).orElse(Place.WHOLE);
  }

  static Place place(Mark mark) {
    return new Place(mark.getLine() + 1, mark.getColumn() + 1);
  }
}
