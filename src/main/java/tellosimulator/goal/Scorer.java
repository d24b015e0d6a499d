package tellosimulator.goal;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.function.Consumer;
import tellosimulator.command.WireText;
import tellosimulator.controller.FlightEvent;
import tellosimulator.goal.Progress.Status;
import tellosimulator.goal.Score.Entry;
import tellosimulator.model.FlightPhase;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.words.Phrase;

/**
 * Keeps the score and the {@link Tally} of an attempt. Goes on after the verdict until all drones
 * are on the ground. Confined to the simulation thread.
 */
final class Scorer {

  /**
   * Number of infractions that have an entry of their own. Decided: more than anyone reads; further
   * ones share an entry, so that a flood of refused commands costs little.
   */
  private static final int MOST_PENALTIES = 100;

  private final Challenge challenge;
  private final Scoring scoring;
  private final Consumer<Entry> penalties;
  private final Map<Infraction, Integer> counts = new EnumMap<>(Infraction.class);
  private final List<OptionalInt> winners;

  /**
   * The drones in the air by their numbers, with the reason why a drone comes down other than by a
   * command to land.
   */
  private final Map<Integer, Optional<Phrase>> airborne = new TreeMap<>();

  private final List<Entry> entries = new ArrayList<>();

  /** The entry that infractions share after the first {@link #MOST_PENALTIES}. */
  private Optional<Entry> further = Optional.empty();

  /** The entry for the time after par; grows while drones fly. */
  private Optional<Entry> late = Optional.empty();

  private Optional<Score> score;
  private int commands;

  /** The number of infractions that cost points. */
  private int charged;

  private boolean tookOff;

  /** Whether the verdict is final. */
  private boolean judged;

  /** Whether nothing counts any more. */
  private boolean closed;

  /**
   * Creates the scorer of an attempt.
   *
   * @param penalties receives each entry with points that were lost by an infraction
   */
  Scorer(Challenge challenge, Consumer<Entry> penalties) {
    this.challenge = challenge;
    this.penalties = penalties;
    scoring = challenge.scoring().orElse(Scoring.GOALS_ONLY);
    winners = new ArrayList<>(Collections.nCopies(challenge.goals().size(), OptionalInt.empty()));
    score = Progress.start(challenge).score();
  }

  /** Returns the current score; empty if the challenge has no points. */
  Optional<Score> score() {
    return score;
  }

  Tally tally() {
    return new Tally(commands, counts, winners);
  }

  /**
   * Counts an event of a drone.
   *
   * @param second the time since the first takeoff [s]; 0 before it
   */
  void take(SimEvent.ForDrone event, double second) {
    if (closed) {
      return;
    }
    if (event instanceof SimEvent.CommandReceived) {
      commands++;
    } else if (event instanceof SimEvent.CommandRefused refused && counting()) {
      String text = WireText.printable(refused.text());
      count(
          Infraction.REFUSED,
          second,
          Phrase.of("drone %d refused `%s`: %s", refused.drone(), text, refused.reason()));
    } else if (event instanceof SimEvent.CommandFailed failed && counting()) {
      String text = WireText.printable(failed.text());
      count(
          Infraction.REFUSED,
          second,
          Phrase.of("drone %d failed at `%s`: %s", failed.drone(), text, failed.reason()));
    } else if (event instanceof SimEvent.DroneFlight flight) {
      take(flight.drone(), flight.event(), second);
    }
  }

  /**
   * Whether a refused command counts. After a landing none does until the next takeoff, because
   * such commands do not belong to a flight.
   */
  private boolean counting() {
    return !(tookOff && airborne.isEmpty());
  }

  private void take(int drone, FlightEvent event, double second) {
    if (event instanceof FlightEvent.Touched touch) {
      Phrase touched = touch.touched().phrase();
      count(Infraction.TOUCH, second, Phrase.of("drone %d touched %s", drone, touched));
    } else if (event instanceof FlightEvent.Crashed crash) {
      Phrase touched = crash.touched().phrase();
      count(Infraction.CRASH, second, Phrase.of("drone %d crashed into %s", drone, touched));
    } else if (event instanceof FlightEvent.LandsByItself landing) {
      airborne.put(drone, Optional.of(landing.phrase()));
    } else if (event instanceof FlightEvent.Fell fall) {
      airborne.put(drone, Optional.of(fall.phrase()));
    } else if (event instanceof FlightEvent.LandingCanceled) {
      airborne.put(drone, Optional.empty());
    }
  }

  /**
   * Notes which drones are in the air at the end of a step, and judges the landings of others.
   * Until the verdict, the time in the air counts against par; the time on the ground after the
   * last landing does not, so that waiting for the verdict costs nothing.
   *
   * @param second the time since the first takeoff [s]; 0 before it
   */
  void step(List<DroneSnapshot> drones, double second) {
    if (closed) {
      return;
    }
    boolean flew = !airborne.isEmpty();
    for (DroneSnapshot drone : drones) {
      int number = drone.state().drone();
      FlightPhase phase = drone.state().phase();
      if (phase.flying()) {
        tookOff = true;
        airborne.putIfAbsent(number, Optional.empty());
      } else if (phase != FlightPhase.FALLING && airborne.containsKey(number)) {
        Optional<Phrase> cause = airborne.remove(number);
        if (phase == FlightPhase.OFF) {
          Phrase off = Phrase.of("drone %d was switched off in flight", number);
          count(Infraction.NOT_LANDED, second, off);
        } else if (cause.isPresent() && phase != FlightPhase.CRASHED) {
          Phrase landed = Phrase.of("drone %d %s", number, cause.get());
          count(Infraction.NOT_LANDED, second, landed);
        }
      }
    }
    if (flew && !judged) {
      scoring.par().filter(par -> second > par.seconds()).ifPresent(par -> late(par, second));
    }
    closed = judged && airborne.isEmpty();
  }

  private void late(Scoring.Par par, double second) {
    double seconds = second - par.seconds();
    Phrase why = Phrase.of("%.1f s over par (%.1f s)", seconds, par.seconds());
    late = Optional.of(new Entry(second, -seconds * par.eachSecond(), why));
    update();
  }

  /** Counts a goal that was reached. */
  void reached(int index, int drone, double second) {
    winners.set(index, OptionalInt.of(drone));
    Goal goal = challenge.goals().get(index);
    Phrase why =
        Phrase.of("reached goal %d of %d: %s", index + 1, challenge.goals().size(), goal.task());
    add(new Entry(second, goal.terms().points(), why));
  }

  /** Adds the bonus, once the verdict is final. */
  void judge(Progress verdict) {
    if (judged) {
      return;
    }
    judged = true;
    if (verdict.status() == Status.REACHED) {
      double elapsed = verdict.elapsed();
      Phrase why = Phrase.of("all goals are reached after %.1f s", elapsed);
      scoring.bonus().ifPresent(bonus -> add(new Entry(elapsed, bonus.after(elapsed), why)));
    }
  }

  /**
   * Counts the drones that are still in the air at the end of the run. This is no event of the
   * simulation, so it is not reported as one.
   *
   * @param second the time since the first takeoff [s]
   */
  void close(double second) {
    if (!closed) {
      for (int drone : airborne.keySet()) {
        Phrase why = Phrase.of("drone %d was still in the air at the end", drone);
        charge(Infraction.NOT_LANDED, second, why);
      }
    }
    closed = true;
  }

  private void count(Infraction infraction, double second, Phrase why) {
    charge(infraction, second, why).ifPresent(penalties);
  }

  /** Counts an infraction; returns its entry, if it has one of its own. */
  private Optional<Entry> charge(Infraction infraction, double second, Phrase why) {
    counts.merge(infraction, 1, Integer::sum);
    Entry entry = new Entry(second, -scoring.penalties().getOrDefault(infraction, 0.0), why);
    if (entry.points() == 0 || score.isEmpty()) {
      return Optional.empty();
    }
    charged++;
    if (charged <= MOST_PENALTIES) {
      add(entry);
      return Optional.of(entry);
    }
    double points = further.map(Entry::points).orElse(0.0) + entry.points();
    Phrase all = Phrase.of("%d further penalties", charged - MOST_PENALTIES);
    further = Optional.of(new Entry(second, points, all));
    update();
    return Optional.empty();
  }

  /** Adds an entry, unless it has no points. */
  private void add(Entry entry) {
    if (entry.points() != 0) {
      entries.add(entry);
      update();
    }
  }

  private void update() {
    List<Entry> all = new ArrayList<>(entries);
    further.ifPresent(all::add);
    late.filter(entry -> entry.points() != 0).ifPresent(all::add);
    all.sort(Comparator.comparingDouble(Entry::second));
    score = score.map(before -> Score.of(challenge, all));
  }
}
