package tellosimulator.headless;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;
import tellosimulator.words.Phrase;

/**
 * When a run ends by itself. It waits for the verdict on a program: until goals are reached or
 * missed, until nobody flies any more, or has flown, and no command comes, until the timeout, or
 * until the program has ended and all drones are down; and then until the drones have come down, so
 * that no program loses its drone on the way to the ground.
 *
 * <p>Hears of steps and events on the simulation thread; the others wait on threads of their own.
 */
final class ExitCondition implements SimListener {

  /** Silence of standing drones that ends it [s]. Decided: as long as one in flight waits. */
  private static final double SILENCE = 15;

  /**
   * Silence that ends it of a program that has sent something, but let no drone take off [s], such
   * as one whose takeoff was lost. Decided: a minute, for programs that begin with looking around.
   */
  private static final double UNFLOWN_SILENCE = 60;

  /** Longest time that drones may stay in the air after the verdict [s]. Decided: to fly back. */
  private static final double LONGEST_FLIGHT = 10;

  /** How long the last replies may take after that [s]. Measured: at most 0.05 s. */
  private static final double REPLIES = 0.1;

  /** The same where simulated time stands still, because nothing moves any more [ms]. */
  private static final int REPLIES_MS = 500;

  /** How often it is looked whether simulated time stands still [ms]. */
  private static final int LOOK_MS = 50;

  /**
   * How long a program may think while time stands still.
   *
   * @param landed after all drones have landed [looks]. Decided: 2 s, much longer than from the
   *     reply to {@code land} to the next command, and short for whoever waits for the verdict
   * @param ready between the first command and the first takeoff, where there is a timeout [looks].
   *     Decided: 3 s, to open a stream or a window, and short for whoever waits for the timeout
   * @param busy while a drone is in the air, or before the first command, or the first takeoff
   *     where there is no timeout [looks]. Decided: 30 s, for programs that compute between two
   *     commands, or start slowly
   */
  record IdleLimits(int landed, int ready, int busy) {
    static final IdleLimits DEFAULT =
        new IdleLimits(2000 / LOOK_MS, 3000 / LOOK_MS, 30_000 / LOOK_MS);
  }

  /** Simulated time, where it stands still while nothing moves. */
  interface Standstill {

    /** Whether time passes only while something moves. */
    boolean possible();

    /** Lets time pass though nothing moves [s]. */
    void pass(double seconds);
  }

  private final GoalWatch goals;
  private final IdleLimits limits;
  private final AtomicLong steps = new AtomicLong();
  private final CountDownLatch result = new CountDownLatch(1);
  private final CountDownLatch landed = new CountDownLatch(1);
  private final CountDownLatch answered = new CountDownLatch(1);
  private final CountDownLatch finished = new CountDownLatch(1);
  private volatile Optional<Progress> progress = Optional.empty();
  private volatile Optional<Double> timeout = Optional.empty();
  private volatile boolean standing = true;
  private volatile boolean spoken;
  private volatile boolean finishing;
  private volatile SimTime now = SimTime.ZERO;

  /** When something flew or a command came for the last time. */
  private SimTime quietSince = SimTime.ZERO;

  private Optional<SimTime> resultAt = Optional.empty();
  private Optional<SimTime> landedAt = Optional.empty();

  /**
   * @param goals is told of each step before
   */
  ExitCondition(GoalWatch goals) {
    this(goals, IdleLimits.DEFAULT);
  }

  ExitCondition(GoalWatch goals, IdleLimits limits) {
    this.goals = goals;
    this.limits = limits;
  }

  /** After how much simulated time the goals are missed, whatever drones do [s]. */
  void limit(Optional<Double> newTimeout) {
    timeout = newTimeout;
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.CommandReceived) {
      quietSince = event.time();
      spoken = true;
    }
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    now = snapshot.time();
    standing = snapshot.drones().stream().noneMatch(drone -> drone.state().phase().flying());
    if (!standing) {
      quietSince = now;
    }
    steps.incrementAndGet();
    if (resultAt.isEmpty()) {
      progress = verdict();
      if (progress.isEmpty()) {
        return;
      }
      resultAt = Optional.of(now);
    }
    result.countDown();
    if (landedAt.isPresent() || standing || now.since(resultAt.get()) > LONGEST_FLIGHT) {
      landedAt = Optional.of(landedAt.orElse(now));
      landed.countDown();
      if (now.since(landedAt.get()) >= REPLIES) {
        answered.countDown();
      }
    }
  }

  private Optional<Progress> verdict() {
    Progress present = goals.progress();
    if (present.status() != Status.RUNNING) {
      return Optional.of(present);
    }
    if (finishing && standing) {
      return Optional.of(missed(Phrase.of("the program has ended")));
    }
    if (begun() && now.since(quietSince) >= SILENCE) {
      return Optional.of(
          missed(Phrase.of("all drones have landed, and no command came for %.0f s", SILENCE)));
    }
    if (!begun() && spoken && now.since(quietSince) >= UNFLOWN_SILENCE) {
      return Optional.of(
          missed(Phrase.of("no drone took off, and no command came for %.0f s", UNFLOWN_SILENCE)));
    }
    return timeout
        .filter(limit -> now.seconds() >= limit)
        .map(
            limit ->
                missed(
                    begun()
                        ? Phrase.of("the timeout of %.0f s is over", limit)
                        : Phrase.of("no drone took off within %.0f s", limit)));
  }

  private Progress missed(Phrase reason) {
    Progress present = goals.progress();
    return new Progress(
        present.challenge(), present.reached(), present.elapsed(), Optional.of(reason));
  }

  private boolean begun() {
    return goals.progress().elapsed() > 0;
  }

  /** No command comes any more, and all drones that are in the air land. */
  void finish() {
    finishing = true;
    finished.countDown();
  }

  /** Waits for {@link #finish} or {@link #now}. */
  void awaitFinish() throws InterruptedException {
    finished.await();
  }

  /**
   * Waits for {@link #finish} or {@link #now}.
   *
   * @param limitMs for how long [ms]
   */
  @SuppressWarnings("ReturnValueIgnored") // whichever comes first
  void awaitFinish(long limitMs) throws InterruptedException {
    finished.await(limitMs, TimeUnit.MILLISECONDS);
  }

  /** Waits no longer. */
  void now() {
    finished.countDown();
    result.countDown();
    landed.countDown();
    answered.countDown();
  }

  /** Waits for the verdict, which stays the same whatever happens afterwards. */
  Progress awaitResult(Standstill standstill) throws InterruptedException {
    int looks = 0;
    for (long before = -1; !result.await(LOOK_MS, TimeUnit.MILLISECONDS); before = steps.get()) {
      looks = steps.get() == before && standstill.possible() ? looks + 1 : 0;
      boolean waits = spoken || timeout.isPresent() || finishing;
      if (waits && looks >= mostLooks()) {
        standstill.pass(silence());
        looks = 0;
      }
    }
    return progress.orElseGet(goals::progress);
  }

  private int mostLooks() {
    if (finishing) {
      return 1;
    }
    if (begun()) {
      return standing ? limits.landed() : limits.busy();
    }
    return spoken && timeout.isPresent() ? limits.ready() : limits.busy();
  }

  /** What may pass before there is a verdict [s]. */
  private double silence() {
    if (finishing) {
      return REPLIES;
    }
    if (begun()) {
      return SILENCE;
    }
    return spoken
        ? Math.min(UNFLOWN_SILENCE, timeout.orElse(UNFLOWN_SILENCE))
        : timeout.orElseThrow();
  }

  /** Waits for the drones and their last replies, but not where time stands still. */
  @SuppressWarnings("ReturnValueIgnored") // whichever comes first
  void awaitRest(Standstill standstill) throws InterruptedException {
    int looks = 0;
    long before = -1;
    while (looks < limits.busy() && !landed.await(LOOK_MS, TimeUnit.MILLISECONDS)) {
      looks = steps.get() == before && standstill.possible() ? looks + 1 : 0;
      before = steps.get();
    }
    answered.await(REPLIES_MS, TimeUnit.MILLISECONDS);
  }
}
