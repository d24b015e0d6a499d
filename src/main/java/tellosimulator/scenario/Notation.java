package tellosimulator.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.goal.Goal;
import tellosimulator.math.Vec3;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/**
 * How a file writes an obstacle where it has a choice. Immutable.
 *
 * @param kind its key: a {@code wall} is a box, too
 * @param named whether it has a name of its own, rather than one such as {@code box 1}
 * @param wall its ends as they were read; empty for what is no wall, or was not read
 */
record Notation(String kind, boolean named, Optional<Wall> wall) {

  static final String WALL = "wall";

  /** The ends of a wall, on the floor [m]. */
  record Ends(Vec3 from, Vec3 to) {}

  /** A wall as it was read: where its ends are written to be, and what became of it. */
  record Wall(Ends ends, Obstacle obstacle) {}

  /** Of an obstacle that no file has yet. */
  static Notation usual(Obstacle obstacle) {
    return new Notation(kind(obstacle.shape()), true, Optional.empty());
  }

  private static String kind(Shape shape) {
    if (shape instanceof Shape.Box) {
      return "box";
    }
    return shape instanceof Shape.Cylinder ? "cylinder" : "gate";
  }

  boolean isWall() {
    return kind.equals(WALL);
  }

  /** Whether an obstacle can be written so. */
  boolean fits(Obstacle obstacle) {
    String usual = kind(obstacle.shape());
    return kind.equals(usual) || (isWall() && usual.equals("box"));
  }

  /** The same for what became of the same text in another calculation. */
  Notation of(Obstacle obstacle) {
    return new Notation(kind, named, wall.map(read -> new Wall(read.ends(), obstacle)));
  }

  Notation withEnds(Ends ends, Obstacle obstacle) {
    return new Notation(kind, named, Optional.of(new Wall(ends, obstacle)));
  }

  Notation withName() {
    return new Notation(kind, true, wall);
  }

  /**
   * The ends of a wall. One that was only moved has its ends moved, because those that follow from
   * its middle, length and heading differ by millionths.
   */
  Ends ends(Obstacle obstacle) {
    Optional<Wall> moved =
        wall.filter(
            read ->
                read.obstacle().shape().equals(obstacle.shape())
                    && read.obstacle().heading() == obstacle.heading());
    if (moved.isPresent()) {
      Ends ends = moved.get().ends();
      Vec3 way = obstacle.foot().minus(moved.get().obstacle().foot());
      return new Ends(ends.from().plus(way), ends.to().plus(way));
    }
    double half = ((Shape.Box) obstacle.shape()).width() / 2;
    double heading = obstacle.heading();
    Vec3 along = new Vec3(-StrictMath.sin(heading) * half, StrictMath.cos(heading) * half, 0);
    return new Ends(obstacle.foot().minus(along), obstacle.foot().plus(along));
  }

  // --- how a file writes all its obstacles ---

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
    List<ObstacleCodecs.NotedObstacle> entries = new ArrayList<>();
    for (Notation notation : notations) {
      Obstacle obstacle = obstacles.get(entries.size());
      entries.add(
          new ObstacleCodecs.NotedObstacle(
              notation, notation.named() ? obstacle : obstacle.named("")));
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
