package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.goal.Goal;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Notation.Ends;
import tellosimulator.scenario.Notation.Wall;
import tellosimulator.scenario.SyntaxTree.Collection;
import tellosimulator.scenario.SyntaxTree.Element;
import tellosimulator.scenario.SyntaxTree.Leaf;
import tellosimulator.scenario.SyntaxTree.Syntax;
import tellosimulator.world.Obstacle;

/** How a file writes all its obstacles. */
final class Notations {

  private Notations() {}

  /** Those of a text, in the order of the obstacles that were read from it. */
  static List<Notation> read(Scenario scenario, Syntax file) {
    List<Obstacle> obstacles = scenario.config().arena().obstacles();
    Optional<Syntax> list = file.element("obstacles").map(Element::value);
    List<Element> items =
        list.isPresent() && list.get() instanceof Collection written
            ? written.elements()
            : List.of();
    List<Notation> notations = new ArrayList<>();
    for (int i = 0; i < obstacles.size(); i++) {
      notations.add(
          items.size() == obstacles.size()
              ? read(obstacles.get(i), items.get(i).value())
              : Notation.usual(obstacles.get(i)));
    }
    return notations;
  }

  private static Notation read(Obstacle obstacle, Syntax item) {
    if (!(item instanceof Collection one) || one.elements().size() != 1) {
      return Notation.usual(obstacle);
    }
    Syntax inner = one.elements().get(0).value();
    Optional<String> kind = one.elements().get(0).key();
    if (kind.isEmpty() || !(inner instanceof Collection)) {
      return Notation.usual(obstacle);
    }
    Optional<Vec3> from = point(inner, "from");
    Optional<Vec3> to = point(inner, "to");
    Optional<Wall> wall =
        from.isPresent() && to.isPresent()
            ? Optional.of(new Wall(new Ends(from.get(), to.get()), obstacle))
            : Optional.empty();
    return new Notation(kind.get(), inner.element("name").isPresent(), wall);
  }

  /** A place on the floor [m], where it can be seen without looking up aliases. */
  private static Optional<Vec3> point(Syntax mapping, String key) {
    Optional<Syntax> written = mapping.element(key).map(Element::value);
    if (written.isEmpty() || !(written.get() instanceof Collection list)) {
      return Optional.empty();
    }
    List<Double> numbers = new ArrayList<>();
    for (Element item : list.elements()) {
      if (item.value() instanceof Leaf leaf && leaf.value().isPresent()) {
        numbers.add(Frames.metres(Values.rounded(Double.parseDouble(leaf.value().get()))));
      }
    }
    return numbers.size() == 2
        ? Optional.of(new Vec3(numbers.get(0), numbers.get(1), 0))
        : Optional.empty();
  }

  /**
   * How the obstacles of a changed scenario are written: as before, the new ones as usual. One
   * without a name gets one where it would be another than now, and a goal speaks of it.
   *
   * @param matches for each obstacle, its index before
   */
  static List<Notation> kept(List<Notation> before, List<Integer> matches, Scenario now) {
    List<Obstacle> obstacles = now.config().arena().obstacles();
    List<Notation> notations = new ArrayList<>();
    for (int i = 0; i < obstacles.size(); i++) {
      Obstacle obstacle = obstacles.get(i);
      notations.add(
          Optional.of(matches.get(i))
              .filter(match -> match != Matching.NEW)
              .map(before::get)
              .filter(notation -> notation.fits(obstacle))
              .orElseGet(() -> Notation.usual(obstacle)));
    }
    Set<String> spokenOf = gates(now).collect(Collectors.toSet());
    while (nameOne(notations, obstacles, spokenOf)) {
      // until names that a goal speaks of are right
    }
    return notations;
  }

  /** Names an obstacle that needs it; false if there is none. */
  private static boolean nameOne(
      List<Notation> notations, List<Obstacle> obstacles, Set<String> spokenOf) {
    List<String> names = names(notations, obstacles);
    for (int i = 0; i < names.size(); i++) {
      String name = obstacles.get(i).name();
      boolean matters = spokenOf.contains(name) || spokenOf.contains(names.get(i));
      if (matters && !notations.get(i).named() && !names.get(i).equals(name)) {
        notations.set(i, notations.get(i).withName());
        return true;
      }
    }
    return false;
  }

  /** The names that obstacles have when they are read. */
  private static List<String> names(List<Notation> notations, List<Obstacle> obstacles) {
    Set<String> taken = new HashSet<>();
    List<ObstacleReader.Entry> entries = new ArrayList<>();
    for (int i = 0; i < obstacles.size(); i++) {
      Notation notation = notations.get(i);
      String name = notation.named() ? obstacles.get(i).name() : "";
      taken.add(name);
      Obstacle written = Checks.renamed(obstacles.get(i), name);
      entries.add(new ObstacleReader.Entry(notation.kind(), written));
    }
    return Checks.named(entries, taken);
  }

  /** For each goal that is a gate, which of the obstacles that is; -1 for none. */
  static List<Integer> gatesOfGoals(Scenario scenario) {
    List<String> names =
        scenario.config().arena().obstacles().stream().map(Obstacle::name).toList();
    return gates(scenario).map(names::indexOf).toList();
  }

  private static Stream<String> gates(Scenario scenario) {
    return scenario.challenge().goals().stream()
        .filter(Goal.Pass.class::isInstance)
        .map(goal -> ((Goal.Pass) goal).gate());
  }
}
