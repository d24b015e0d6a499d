package tellosimulator.goal;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import tellosimulator.controller.FlightEvent;
import tellosimulator.goal.Attempt.Missed;
import tellosimulator.goal.Attempt.Outcome;
import tellosimulator.goal.Attempt.Won;
import tellosimulator.goal.Progress.Status;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * Watches a simulation, and judges whether the drones do what a {@link Challenge} asks for. It
 * begins anew whenever a person puts a drone back to its start.
 */
public final class GoalWatch implements SimListener {

  private final Consumer<GoalEvent> news;
  private final AtomicReference<Challenge> asked = new AtomicReference<>();
  private volatile Progress progress;
  private Attempt attempt;
  private SimTime now = SimTime.ZERO;

  /**
   * @param news takes an event for each goal that is reached or nearly so, and for the end; on the
   *     simulation thread, after all other events of the step
   */
  public GoalWatch(Challenge challenge, Consumer<GoalEvent> news) {
    this.news = news;
    this.attempt = new Attempt(challenge);
    this.progress = attempt.progress();
  }

  /** How far the drones have come. For any thread. */
  public Progress progress() {
    return progress;
  }

  /** Asks for something else from the next step on. For any thread. */
  public void ask(Challenge newChallenge) {
    asked.set(newChallenge);
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.Restarted) {
      now = event.time();
      begin(challenge());
    }
    if (!(event instanceof SimEvent.DroneFlight flight)) {
      return;
    }
    if (flight.event() instanceof FlightEvent.PutBack) {
      begin(challenge());
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
    Challenge other = asked.getAndSet(null);
    if (other != null) {
      begin(other);
    }
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
    return attempt.progress().status() == Status.RUNNING && !challenge().goals().isEmpty();
  }

  private Challenge challenge() {
    return attempt.progress().challenge();
  }

  private void begin(Challenge challenge) {
    attempt = new Attempt(challenge);
    progress = attempt.progress();
  }

  private void fail(Phrase reason) {
    attempt.fail(reason);
    publish();
  }

  private void publish() {
    progress = attempt.progress();
    switch (progress.status()) {
      case RUNNING -> {}
      case REACHED ->
          news.accept(
              new GoalEvent.Over(
                  now, Phrase.of("all goals are reached after %.1f s", progress.elapsed()), false));
      case FAILED -> news.accept(new GoalEvent.Over(now, progress.phrase(), true));
    }
  }

  private void tell(Won won) {
    Progress present = attempt.progress();
    Goal goal = present.challenge().goals().get(won.index());
    news.accept(
        new GoalEvent.Reached(
            now,
            won.drone(),
            Phrase.of(
                "reached goal %d of %d after %.1f s: %s",
                won.index() + 1, present.reached().size(), present.elapsed(), goal.task())));
  }
}
