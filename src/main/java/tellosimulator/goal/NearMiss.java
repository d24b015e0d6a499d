package tellosimulator.goal;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.goal.Course.Gate;
import tellosimulator.goal.Observation.Crossing;
import tellosimulator.goal.Observation.Sight;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.MissionPad;

/**
 * Detects whether a drone has nearly reached a goal in a step, and explains why this does not
 * count. A near miss is a landing beside the place of a goal, a flight past a gate or through it in
 * the wrong direction, a target that is too small in the picture or leaves it too soon, or reaching
 * a goal before its turn.
 */
final class NearMiss {

  /**
   * Maximum distance from the frame of a gate at which a drone counts as flying past the gate [m].
   * Decided: at a greater distance, the drone is on its way elsewhere.
   */
  private static final double PAST = 0.75;

  private final Observation seen;
  private final Progress progress;

  private NearMiss(Observation seen, Progress progress) {
    this.seen = seen;
    this.progress = progress;
  }

  /**
   * Returns the near miss as a clause about the drone, such as {@code landed at x 26, y 0, 26 cm
   * from the middle of goal 4; up to 15 cm count}.
   *
   * @param seen the observation of a drone that has reached no goal in this step
   */
  static Optional<Phrase> of(Observation seen, Progress progress) {
    NearMiss miss = new NearMiss(seen, progress);
    return seen.justLanded() ? miss.landing() : miss.gate().or(miss::sight);
  }

  /**
   * Explains a landing. The landing is assumed to be an attempt at the next landing goal if the
   * goals must be reached in order, and otherwise at the nearest landing goal.
   */
  private Optional<Phrase> landing() {
    Stream<Landing> landings = open().mapToObj(this::landing).flatMap(Optional::stream);
    return (progress.challenge().inOrder()
            ? landings.findFirst()
            : landings.min(Comparator.comparingDouble(Landing::distance)))
        .flatMap(this::landing);
  }

  private Optional<Phrase> landing(Landing landing) {
    if (landing.distance() <= landing.limit()) {
      return early(landing.index())
          .map(
              first ->
                  Phrase.of(
                      "landed at goal %d, but goal %d comes first", landing.index() + 1, first));
    }
    Vec3 feet = seen.now().motion().position();
    return Optional.of(
        Phrase.of(
            "landed at x %.0f, y %.0f, %.0f cm from the middle of goal %d; up to %.0f cm count",
            feet.x() * 100,
            feet.y() * 100,
            landing.distance() * 100,
            landing.index() + 1,
            landing.limit() * 100));
  }

  /**
   * A landing, compared with a landing goal.
   *
   * @param index the index of the goal, from 0
   * @param distance the horizontal distance of the drone from the goal's middle [m]
   * @param limit the maximum distance that counts [m]
   */
  private record Landing(int index, double distance, double limit) {}

  private Optional<Landing> landing(int index) {
    Goal goal = goal(index);
    if (goal instanceof Goal.Land land) {
      return Optional.of(new Landing(index, level(land.region().place()), land.region().radius()));
    }
    return goal instanceof Goal.LandOn on
        ? seen.course()
            .card(on.pad())
            .map(card -> new Landing(index, level(card.position()), MissionPad.EDGE / 2))
        : Optional.empty();
  }

  private double level(Vec3 place) {
    return seen.now().motion().position().minus(place).horizontal().norm();
  }

  private Optional<Phrase> gate() {
    return open().mapToObj(this::gate).flatMap(Optional::stream).findFirst();
  }

  private Optional<Phrase> gate(int index) {
    return goal(index) instanceof Goal.Pass pass
        ? seen.course().gate(pass.gate()).flatMap(gate -> gate(index, pass, gate))
        : Optional.empty();
  }

  private Optional<Phrase> gate(int index, Goal.Pass pass, Gate gate) {
    Optional<Crossing> crossed = seen.crossing(gate);
    if (crossed.isEmpty()) {
      return Optional.empty();
    }
    Crossing crossing = crossed.get();
    if (!crossing.through()) {
      boolean past =
          StrictMath.hypot(crossing.across(), crossing.up()) < gate.opening().reach() + PAST
              && early(index).isEmpty();
      return past
          ? Optional.of(
              Phrase.of(
                  "flew past gate %s: at z %.0f instead of %.0f, %.0f cm beside its middle",
                  pass.gate(),
                  (gate.opening().middle() + crossing.up()) * 100,
                  gate.opening().middle() * 100,
                  Math.abs(crossing.across()) * 100))
          : Optional.empty();
    }
    if (!crossing.goes(pass.direction())) {
      return Optional.of(Phrase.of("flew through gate %s in the wrong direction", pass.gate()));
    }
    return early(index)
        .map(
            first ->
                Phrase.of("flew through gate %s, but goal %d comes first", pass.gate(), first));
  }

  /** Explains a sight, once until there is another near miss. */
  private Optional<Phrase> sight() {
    return open()
        .mapToObj(this::sight)
        .flatMap(Optional::stream)
        .filter(phrase -> progress.miss().filter(last -> last.values().contains(phrase)).isEmpty())
        .findFirst();
  }

  private Optional<Phrase> sight(int index) {
    if (!(goal(index) instanceof Goal.See see)) {
      return Optional.empty();
    }
    Sight now = seen.sight(see);
    Sight before = seen.sightBefore(see);
    Phrase target = see.target().phrase();
    Optional<Integer> early = early(index);
    if (early.isPresent()) {
      return now == Sight.FULL && before != Sight.FULL
          ? Optional.of(Phrase.of("saw %s, but goal %d comes first", target, early.get()))
          : Optional.empty();
    } else if (before == Sight.FULL && now != Sight.FULL) {
      return Optional.of(
          Phrase.of("saw %s too briefly: %.1f s without a break count", target, see.seconds()));
    }
    return before == Sight.NONE && now == Sight.SMALL
        ? Optional.of(Phrase.of("saw %s, but too small: fly closer", target))
        : Optional.empty();
  }

  private Goal goal(int index) {
    return progress.challenge().goals().get(index);
  }

  /** Returns the indices of the goals that have not been reached, and that this drone may reach. */
  private IntStream open() {
    return IntStream.range(0, progress.reached().size())
        .filter(index -> progress.reached().get(index).isEmpty())
        .filter(index -> goal(index).drone().orElse(seen.drone()) == seen.drone());
  }

  /**
   * Returns the number of the goal that must be reached before the goal with the given index; empty
   * if the goal with this index can be reached now.
   */
  private Optional<Integer> early(int index) {
    return progress.state(index) == GoalState.ACTIVE
        ? Optional.empty()
        : Optional.of(progress.count() + 1);
  }
}
