package tellosimulator.goal;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.goal.Observation.Course.Gate;
import tellosimulator.goal.Observation.Crossing;
import tellosimulator.math.Vec3;
import tellosimulator.words.Phrase;
import tellosimulator.world.MissionPad;

/**
 * What a drone did in a step that was meant to reach a goal, as it seems, and why it does not
 * count: a landing beside its place, or a flight past a gate, through it the wrong way, or too
 * early.
 */
final class NearMiss {

  /** How far beyond the frame of a gate one flies past it [m]. Decided: beyond is another way. */
  private static final double PAST = 0.75;

  private final Observation seen;
  private final Progress progress;

  private NearMiss(Observation seen, Progress progress) {
    this.seen = seen;
    this.progress = progress;
  }

  /**
   * A clause about the drone: {@code landed at x 26, y 0, 26 cm from the middle of goal 4; up to 15
   * cm count}.
   *
   * @param seen of a drone that has reached no goal in this step
   */
  static Optional<Phrase> of(Observation seen, Progress progress) {
    NearMiss miss = new NearMiss(seen, progress);
    return seen.justLanded() ? miss.landing() : miss.gate();
  }

  /** A landing is meant for the next landing goal; without an order, for the nearest one. */
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
   * A landing that is asked for.
   *
   * @param index of the goal, from 0
   * @param distance of the drone from the goal's middle, level [m]
   * @param limit up to which it counts [m]
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

  private Goal goal(int index) {
    return progress.challenge().goals().get(index);
  }

  /** The indices of the goals that are still to be reached, by this drone. */
  private IntStream open() {
    return IntStream.range(0, progress.reached().size())
        .filter(index -> progress.reached().get(index).isEmpty())
        .filter(index -> goal(index).drone().orElse(seen.drone()) == seen.drone());
  }

  /** The number of the goal that must be reached before one; empty if there is none. */
  private Optional<Integer> early(int index) {
    return progress.state(index) == GoalState.ACTIVE
        ? Optional.empty()
        : Optional.of(progress.count() + 1);
  }
}
