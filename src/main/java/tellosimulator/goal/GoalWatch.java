package tellosimulator.goal;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import tellosimulator.controller.FlightEvent;
import tellosimulator.goal.Attempt.Missed;
import tellosimulator.goal.Attempt.Outcome;
import tellosimulator.goal.Attempt.Won;
import tellosimulator.goal.Progress.Status;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimInput;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Watches a simulation, and evaluates whether the drones complete a {@link Challenge}. The attempt
 * starts again with each run, and whenever a drone is put back at its start. After the verdict,
 * mistakes still cost points until all drones are on the ground.
 */
public final class GoalWatch implements SimListener {

  private final Consumer<GoalEvent> news;
  private final AtomicReference<Challenge> asked = new AtomicReference<>();
  private volatile Progress progress;
  private Attempt attempt;
  private SimTime now = SimTime.ZERO;

  /** The time of the event or step that is being evaluated. */
  private SimTime moment = SimTime.ZERO;

  /**
   * Creates a watch for a challenge.
   *
   * @param news receives an event for each goal that is reached or nearly reached, for lost points,
   *     and for the end of the attempt; called on the simulation thread
   */
  public GoalWatch(Challenge challenge, Consumer<GoalEvent> news) {
    this.news = news;
    this.attempt = new Attempt(challenge, this::tell);
    this.progress = attempt.progress();
  }

  /** Returns the drones' progress. Thread-safe. */
  public Progress progress() {
    return progress;
  }

  /** Replaces the challenge. The new challenge takes effect with the next step. Thread-safe. */
  public void ask(Challenge newChallenge) {
    asked.set(newChallenge);
  }

  /**
   * Counts what happens in the present attempt. Must be called on the simulation thread, or after
   * the simulation has closed.
   */
  public Tally tally() {
    return attempt.tally();
  }

  /**
   * Ends the attempt, if it goes on, and charges the drones that are still in the air. Must be
   * called after the simulation has closed.
   */
  public synchronized void close() {
    attempt.close(moment);
    progress = attempt.progress();
  }

  @Override
  public void onInput(SimTime time, SimInput input) {
    if (input instanceof SimInput.Act act && act.control() instanceof Control.EndAttempt) {
      attempt.judge();
      progress = attempt.progress();
    }
  }

  @Override
  public void event(SimEvent event) {
    moment = event.time();
    if (event instanceof SimEvent.RunStarted) {
      now = event.time();
      begin(challenge());
    }
    if (event instanceof SimEvent.ForDrone happened) {
      attempt.take(happened);
      progress = attempt.progress();
    }
    if (!(event instanceof SimEvent.DroneFlight flight)) {
      return;
    }
    if (flight.event() instanceof FlightEvent.PutBack) {
      begin(challenge());
    } else if (running()
        && flight.event() instanceof FlightEvent.LandsByItself landing
        && landing.cause() == FlightEvent.LandingCause.END_OF_PROGRAM) {
      fail(Phrase.of("the program ended while drone %d was in the air", flight.drone()));
    } else if (running() && flight.event() instanceof FlightEvent.Crashed crash) {
      fail(Phrase.of("drone %d crashed into %s", flight.drone(), crash.touched().phrase()));
    } else if (running()
        && challenge().untouched()
        && flight.event() instanceof FlightEvent.Touched touch) {
      fail(Phrase.of("drone %d touched %s", flight.drone(), touch.touched().phrase()));
    }
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    now = snapshot.time();
    moment = now;
    Challenge other = asked.getAndSet(null);
    if (other != null) {
      begin(other);
    }
    attempt.settle(snapshot);
    progress = attempt.progress();
    if (!running()) {
      return;
    }
    Outcome outcome = attempt.advance(snapshot);
    outcome.won().forEach(this::tell);
    for (Missed miss : outcome.missed()) {
      news.accept(new GoalEvent.Missed(now, miss.drone(), miss.phrase()));
    }
    publish();
  }

  private boolean running() {
    return attempt.running();
  }

  private Challenge challenge() {
    return attempt.progress().challenge();
  }

  private void begin(Challenge challenge) {
    attempt = new Attempt(challenge, this::tell);
    progress = attempt.progress();
  }

  private void fail(Phrase reason) {
    attempt.fail(reason);
    publish();
  }

  private void publish() {
    if (attempt.progress().status() != Status.RUNNING) {
      attempt.judge();
    }
    progress = attempt.progress();
    switch (progress.status()) {
      case RUNNING -> {}
      case REACHED -> over(Phrase.of("all goals are reached after %.1f s", progress.elapsed()));
      case FAILED -> over(progress.phrase());
    }
  }

  private void over(Phrase verdict) {
    Phrase whole =
        progress.score().map(score -> Phrase.of("%s; %s", verdict, score.phrase())).orElse(verdict);
    news.accept(new GoalEvent.Over(now, whole, progress.status() == Status.FAILED));
  }

  private void tell(Score.Entry lost) {
    Phrase points = Score.points(-lost.points());
    news.accept(new GoalEvent.Penalty(moment, Phrase.of("%s lost: %s", points, lost.why())));
  }

  private void tell(Won won) {
    Progress present = attempt.progress();
    Goal goal = present.challenge().goals().get(won.index());
    Phrase reached =
        Phrase.of(
            "reached goal %d of %d after %.1f s: %s",
            won.index() + 1, present.reached().size(), present.elapsed(), goal.task());
    double points = goal.terms().points();
    Phrase whole = points > 0 ? Phrase.of("%s (%s)", reached, Score.points(points)) : reached;
    news.accept(new GoalEvent.Reached(now, won.drone(), whole));
  }
}
