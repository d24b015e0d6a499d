package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Supplier;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.nodes.Node;
import tellosimulator.scenario.Mistake.Place;
import tellosimulator.words.Phrase;

/** Collects what is wrong in a file. */
final class Mistakes {

  /** More than anybody reads at once. Decided. */
  private static final int MOST = 100;

  private final String file;
  private final List<Mistake> found = new ArrayList<>();
  private int count;

  Mistakes(String file) {
    this.file = file;
  }

  void add(Node node, Phrase phrase) {
    add(place(node), () -> phrase);
  }

  void add(Place place, Phrase phrase) {
    add(place, () -> phrase);
  }

  /** Beyond the most that are kept, the phrase is not made. */
  void add(Place place, Supplier<Phrase> phrase) {
    count++;
    if (found.size() < MOST) {
      found.add(new Mistake(file, place, phrase.get()));
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
    List<Mistake> sorted = new ArrayList<>(found);
    sorted.sort(Comparator.comparing(Mistake::place));
    if (count > sorted.size()) {
      Place last = sorted.get(sorted.size() - 1).place();
      sorted.add(new Mistake(file, last, Phrase.of("and %d more mistakes", count - sorted.size())));
    }
    throw new ScenarioException(sorted);
  }

  static Place place(Node node) {
    return node.getStartMark().map(Mistakes::place).orElse(Place.WHOLE);
  }

  static Place place(Mark mark) {
    return new Place(mark.getLine() + 1, mark.getColumn() + 1);
  }
}
