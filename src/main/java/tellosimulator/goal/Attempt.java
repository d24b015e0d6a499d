package tellosimulator.goal;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import tellosimulator.goal.Observation.Course;
import tellosimulator.goal.Progress.Status;
import tellosimulator.model.DroneState;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/** One try at a challenge, from the drones' starts to success or failure. */
final class Attempt {

  /**
   * A goal was reached.
   *
   * @param index of the goal, from 0
   * @param drone that reached it
   */
  record Won(int index, int drone) {}

  /**
   * A drone came near a goal.
   *
   * @param phrase a clause about the drone
   */
  record Missed(int drone, Phrase phrase) {}

  /** What came of a step. */
  record Outcome(List<Won> won, List<Missed> missed) {
    static final Outcome NOTHING = new Outcome(List.of(), List.of());
  }

  private final Challenge challenge;
  private final List<Map<Integer, SimTime>> held = new ArrayList<>();
  private final BitSet flown = new BitSet();
  private Optional<Course> course = Optional.empty();
  private List<DroneSnapshot> before = List.of();
  private Optional<SimTime> takeoff = Optional.empty();
  private Progress progress;

  Attempt(Challenge challenge) {
    this.challenge = challenge;
    this.progress = Progress.start(challenge);
    challenge.goals().forEach(goal -> held.add(new HashMap<>()));
  }

  Progress progress() {
    return progress;
  }

  /** The goals cannot be reached any more. */
  void fail(Phrase reason) {
    progress =
        new Progress(
            challenge,
            progress.reached(),
            progress.elapsed(),
            Optional.of(reason),
            progress.miss());
  }

  /**
   * Judges a step.
   *
   * @return the goals that were reached in it, or nearly
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
    won.forEach(win -> reached.set(win.index(), OptionalDouble.of(elapsed)));
    Optional<Phrase> before = won.isEmpty() ? progress.miss() : Optional.empty();
    progress = new Progress(challenge, reached, elapsed, Optional.empty(), before);
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
      Phrase whole = Phrase.of("drone %d %s", miss.drone(), miss.phrase());
      progress =
          new Progress(
              challenge,
              progress.reached(),
              progress.elapsed(),
              Optional.empty(),
              Optional.of(whole));
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

  /** In order, only the next goal can be reached. */
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

  /** The first drone that reaches a goal. */
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
