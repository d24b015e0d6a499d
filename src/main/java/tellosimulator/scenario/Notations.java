package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.goal.Goal;
import tellosimulator.world.Obstacle;

/** How a file writes all its obstacles. */
final class Notations {

  private Notations() {}

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
    List<ObstacleCodecs.Entry> entries = new ArrayList<>();
    for (Notation notation : notations) {
      Obstacle obstacle = obstacles.get(entries.size());
      entries.add(
          new ObstacleCodecs.Entry(notation, notation.named() ? obstacle : obstacle.named("")));
    }
    return ObstacleCodecs.names(entries);
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
