package tellosimulator.goal;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Consumer;
import tellosimulator.goal.Progress.Status;
import tellosimulator.model.DroneState;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/** An attempt at a challenge, from the drones' starts to success or failure. */
final class Attempt {

  /**
   * A goal that was reached.
   *
   * @param index the index of the goal, from 0
   * @param drone the number of the drone that reached it
   */
  record Won(int index, int drone) {}

  /**
   * A goal that was nearly reached.
   *
   * @param phrase a clause about the drone
   */
  record Missed(int drone, Phrase phrase) {}

  /** The outcome of a step. */
  record Outcome(List<Won> won, List<Missed> missed) {
    static final Outcome NOTHING = new Outcome(List.of(), List.of());
  }

  private final Challenge challenge;
  private final List<Map<Integer, SimTime>> held = new ArrayList<>();
  private final BitSet flown = new BitSet();
  private Optional<Course> course = Optional.empty();
  private List<DroneSnapshot> before = List.of();
  private Optional<SimTime> takeoff = Optional.empty();
  private final Scorer scorer;
  private Progress progress;
  private boolean over;

  /**
   * Creates an attempt.
   *
   * @param penalties receives each entry of the score with points that were lost by an infraction
   */
  Attempt(Challenge challenge, Consumer<Score.Entry> penalties) {
    this.challenge = challenge;
    this.progress = Progress.start(challenge);
    this.scorer = new Scorer(challenge, penalties);
    challenge.goals().forEach(goal -> held.add(new HashMap<>()));
  }

  Progress progress() {
    return progress;
  }

  Tally tally() {
    return scorer.tally();
  }

  /** Whether goals can still be reached. */
  boolean running() {
    return !over && progress.status() == Status.RUNNING && !challenge.goals().isEmpty();
  }

  /** Ends the attempt as a failure, because the remaining goals can no longer be reached. */
  void fail(Phrase reason) {
    progress = progress.failed(reason);
  }

  /** Makes the verdict final: no goal can be reached any more, and points for time are added. */
  void judge() {
    over = true;
    scorer.judge(progress);
    progress = progress.withScore(scorer.score());
  }

  /** Ends the attempt together with the run. */
  void close(SimTime now) {
    judge();
    scorer.close(seconds(now));
    progress = progress.withScore(scorer.score());
  }

  /** Counts an event of a drone. */
  void take(SimEvent.ForDrone event) {
    scorer.take(event, seconds(event.time()));
    progress = progress.withScore(scorer.score());
  }

  /** Counts the landings in a step. */
  void settle(SimSnapshot snapshot) {
    scorer.step(snapshot.drones(), seconds(snapshot.time()));
    progress = progress.withScore(scorer.score());
  }

  /** Returns the time since the first takeoff [s]; 0 before it. */
  private double seconds(SimTime now) {
    return takeoff.map(now::since).orElse(0.0);
  }

  /**
   * Evaluates a step.
   *
   * @return the goals that were reached or nearly reached in the step
   */
  Outcome advance(SimSnapshot snapshot) {
    List<Observation> observations = look(snapshot);
    if (takeoff.isEmpty()
        && observations.stream().anyMatch(observation -> observation.now().phase().flying())) {
      takeoff = Optional.of(snapshot.time());
    }
    if (takeoff.isEmpty()) {
      return Outcome.NOTHING;
    }
    SimTime now = snapshot.time();
    double elapsed = now.since(takeoff.get());
    List<Won> won = judge(observations, now);
    List<OptionalDouble> reached = new ArrayList<>(progress.reached());
    won.forEach(
        win -> {
          reached.set(win.index(), OptionalDouble.of(elapsed));
          scorer.reached(win.index(), win.drone(), elapsed);
        });
    Optional<Phrase> before = won.isEmpty() ? progress.miss() : Optional.empty();
    progress = new Progress(challenge, reached, elapsed, Optional.empty(), before, scorer.score());
    List<Missed> missed = won.isEmpty() ? misses(observations) : List.of();
    observations.stream()
        .filter(Observation::lostPower)
        .findFirst()
        .ifPresent(off -> fail(Phrase.of("drone %d was switched off in flight", off.drone())));
    if (progress.status() == Status.RUNNING
        && elapsed >= challenge.timeLimit().orElse(Double.POSITIVE_INFINITY)) {
      fail(Phrase.of("time is over"));
    }
    return new Outcome(won, missed);
  }

  private List<Missed> misses(List<Observation> observations) {
    List<Missed> missed = new ArrayList<>();
    for (Observation observation : observations) {
      NearMiss.of(observation, progress)
          .ifPresent(what -> missed.add(new Missed(observation.drone(), what)));
    }
    for (Missed miss : missed) {
      progress = progress.withMiss(Phrase.of("drone %d %s", miss.drone(), miss.phrase()));
    }
    return missed;
  }

  private List<Observation> look(SimSnapshot snapshot) {
    Course present =
        course
            .map(known -> known.in(snapshot.arena()))
            .orElseGet(() -> new Course(snapshot.arena()));
    course = Optional.of(present);
    List<DroneSnapshot> drones = snapshot.drones();
    List<DroneSnapshot> earlier = before.size() == drones.size() ? before : drones;
    List<Observation> observations = new ArrayList<>(drones.size());
    for (int i = 0; i < drones.size(); i++) {
      DroneState now = drones.get(i).state();
      if (now.phase().flying()) {
        flown.set(i);
      }
      observations.add(new Observation(present, earlier.get(i).state(), now, flown.get(i)));
    }
    before = drones;
    return observations;
  }

  /**
   * Returns the goals reached in a step. If the goals must be reached in order, only the next one
   * can be reached.
   */
  private List<Won> judge(List<Observation> observations, SimTime now) {
    List<Won> won = new ArrayList<>();
    for (int i = 0; i < challenge.goals().size(); i++) {
      if (progress.reached().get(i).isPresent()) {
        continue;
      }
      int index = i;
      OptionalInt winner = winner(i, observations, now);
      winner.ifPresent(drone -> won.add(new Won(index, drone)));
      if (challenge.inOrder()) {
        break;
      }
    }
    return won;
  }

  /** Returns the first drone that reaches a goal, if any. */
  private OptionalInt winner(int index, List<Observation> observations, SimTime now) {
    Goal goal = challenge.goals().get(index);
    Map<Integer, SimTime> since = held.get(index);
    for (Observation observation : observations) {
      int drone = observation.drone();
      if (!observation.reaches(goal)) {
        since.remove(drone);
      } else if (now.since(since.computeIfAbsent(drone, first -> now)) >= goal.lasting()) {
        return OptionalInt.of(drone);
      }
    }
    return OptionalInt.empty();
  }
}
