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
 * Determines when a run ends by itself: once the verdict on the goals is final and the drones have
 * landed, so that no program loses its drone on the way to the ground. The verdict is final when
 * one of the following is true:
 *
 * <ul>
 *   <li>The goals have been reached, or can no longer be reached.
 *   <li>All drones have landed, or none has taken off, and no command has arrived for some time.
 *   <li>The timeout has expired.
 *   <li>The program has ended, and all drones have landed.
 * </ul>
 *
 * <p>This class is notified of steps and events on the simulation thread. Callers wait on their own
 * threads.
 */
final class ExitCondition implements SimListener {

  /**
   * If no command has arrived for this time after all drones have landed, the goals count as missed
   * [s]. Decided: the time without commands after which a flying drone lands automatically.
   */
  private static final double SILENCE = 15;

  /**
   * If a program has sent a command, but no drone has taken off and no further command has arrived
   * for this time, the goals count as missed [s]. This happens, for example, if the takeoff command
   * is lost. Decided: a minute, because some programs first explore what the drone can do.
   */
  private static final double UNFLOWN_SILENCE = 60;

  /**
   * Time for which a program may run without sending any command before the goals count as missed
   * [s]. Decided: two minutes, because some programs have to be built first.
   */
  private static final double UNSENT_SILENCE = 120;

  /**
   * Maximum time for which drones may stay in the air after the verdict [s]. Decided: long enough
   * to fly back.
   */
  private static final double LONGEST_FLIGHT = 10;

  /**
   * Maximum time to wait for the last replies after the drones have landed [s]. Measured: replies
   * take at most 0.05 s.
   */
  private static final double REPLIES = 0.1;

  /**
   * Maximum time to wait for the last replies if simulated time stands still because nothing is
   * moving [ms].
   */
  private static final int REPLIES_MS = 500;

  /** Interval between two checks of whether simulated time has advanced [ms]. */
  private static final int LOOK_MS = 50;

  /**
   * The numbers of successive checks that may find simulated time standing still because a program
   * sends nothing; after that, simulated time is advanced anyway. Which limit applies depends on
   * what the program has done so far.
   *
   * @param landed the limit after all drones have landed [checks]. Decided: 2 s, which is much
   *     longer than programs take from the reply to {@code land} to the next command, yet not a
   *     long wait for the verdict
   * @param ready the limit between the first command and the first takeoff, if there is a timeout
   *     [checks]. Decided: 3 s, enough to open a stream or a window, yet not a long wait for the
   *     timeout
   * @param busy the limit at all other times: while a drone is in the air, before the first
   *     command, and, if there is no timeout, before the first takeoff [checks]. Decided: 30 s, for
   *     programs that start slowly or compute between two commands
   */
  record IdleLimits(int landed, int ready, int busy) {
    static final IdleLimits DEFAULT =
        new IdleLimits(2000 / LOOK_MS, 3000 / LOOK_MS, 30_000 / LOOK_MS);
  }

  /** Access to simulated time that may stand still while nothing is moving. */
  interface Standstill {

    /** Returns whether simulated time advances only while something is moving. */
    boolean possible();

    /**
     * Advances simulated time although nothing is moving.
     *
     * @param seconds the time to advance by [simulated s]
     */
    void pass(double seconds);
  }

  private final GoalWatch goals;
  private final Runnable missing;
  private final IdleLimits limits;

  /** The number of steps and commands so far. */
  private final AtomicLong activity = new AtomicLong();

  private final CountDownLatch result = new CountDownLatch(1);
  private final CountDownLatch landed = new CountDownLatch(1);
  private final CountDownLatch answered = new CountDownLatch(1);
  private final CountDownLatch finished = new CountDownLatch(1);
  private volatile Optional<Progress> progress = Optional.empty();
  private volatile Optional<Double> timeout = Optional.empty();
  private volatile boolean programRuns;
  private volatile boolean standing = true;
  private volatile boolean spoken;
  private volatile boolean finishing;
  private volatile SimTime now = SimTime.ZERO;
  private volatile boolean missed;

  /** The last time at which a drone was in the air or a command arrived. */
  private SimTime quietSince = SimTime.ZERO;

  private Optional<SimTime> resultAt = Optional.empty();
  private Optional<SimTime> landedAt = Optional.empty();

  /**
   * Creates a condition for a run.
   *
   * @param goals must be notified of each step before this condition is
   * @param missing called on the simulation thread when the goals count as missed although they
   *     could still be reached
   */
  ExitCondition(GoalWatch goals, Runnable missing) {
    this(goals, missing, IdleLimits.DEFAULT);
  }

  ExitCondition(GoalWatch goals, Runnable missing, IdleLimits limits) {
    this.goals = goals;
    this.missing = missing;
    this.limits = limits;
  }

  /**
   * Sets the limits of a run.
   *
   * @param newTimeout the time after which the goals count as missed [simulated s]; empty for none
   * @param newProgramRuns whether a program is running that is expected to send commands
   */
  void limit(Optional<Double> newTimeout, boolean newProgramRuns) {
    timeout = newTimeout;
    programRuns = newProgramRuns;
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.CommandReceived) {
      quietSince = event.time();
      activity.incrementAndGet();
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
    activity.incrementAndGet();
    if (resultAt.isEmpty()) {
      progress = judge();
      if (progress.isEmpty()) {
        return;
      }
      resultAt = Optional.of(now);
      if (progress.get().failure().isPresent() && goals.progress().failure().isEmpty()) {
        missed = true;
        missing.run();
      }
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

  private Optional<Progress> judge() {
    Progress present = goals.progress();
    if (finishing && !standing) {
      return Optional.empty(); // the drones must land before the verdict
    }
    if (present.status() != Status.RUNNING) {
      return Optional.of(present);
    }
    if (finishing) {
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
    if (programRuns && !spoken && now.seconds() >= UNSENT_SILENCE) {
      return Optional.of(missed(Phrase.of("no command came for %.0f s", UNSENT_SILENCE)));
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
    return goals.progress().failed(reason);
  }

  private boolean begun() {
    return goals.progress().elapsed() > 0;
  }

  /**
   * Marks the program as ended: no more commands will arrive, and all drones in the air are
   * landing.
   */
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
   * @param limitMs the maximum time to wait [ms]
   */
  @SuppressWarnings("ReturnValueIgnored") // whichever comes first
  void awaitFinish(long limitMs) throws InterruptedException {
    finished.await(limitMs, TimeUnit.MILLISECONDS);
  }

  /** Returns the verdict, which later events do not change; empty if there is none yet. */
  Optional<Progress> verdict() {
    return progress;
  }

  /** Whether goals count as missed that could still have been reached. */
  boolean missed() {
    return missed;
  }

  /** Ends all waiting immediately. */
  void now() {
    finished.countDown();
    result.countDown();
    landed.countDown();
    answered.countDown();
  }

  /** Waits for the verdict; later events do not change it. */
  Progress awaitResult(Standstill standstill) throws InterruptedException {
    int looks = 0;
    long before = -1;
    while (!result.await(LOOK_MS, TimeUnit.MILLISECONDS)) {
      int most = mostLooks(); // before the activity: a command that changes it starts a new count
      long present = activity.get();
      looks = present == before && standstill.possible() ? looks + 1 : 0;
      before = present;
      boolean waits = spoken || timeout.isPresent() || finishing || programRuns;
      if (waits && looks >= most) {
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
    return spoken && timeout.isPresent() && !programRuns ? limits.ready() : limits.busy();
  }

  /** Returns the time without commands after which the verdict is final [simulated s]. */
  private double silence() {
    if (finishing) {
      return REPLIES;
    }
    if (begun()) {
      return SILENCE;
    }
    return spoken
        ? Math.min(UNFLOWN_SILENCE, timeout.orElse(UNFLOWN_SILENCE))
        : timeout.orElse(UNSENT_SILENCE);
  }

  /**
   * Waits until the drones have landed and sent their last replies. Waits only for a limited time
   * if simulated time stands still.
   */
  @SuppressWarnings("ReturnValueIgnored") // whichever comes first
  void awaitRest(Standstill standstill) throws InterruptedException {
    int looks = 0;
    long before = -1;
    while (looks < limits.busy() && !landed.await(LOOK_MS, TimeUnit.MILLISECONDS)) {
      long present = activity.get();
      looks = present == before && standstill.possible() ? looks + 1 : 0;
      before = present;
    }
    answered.await(REPLIES_MS, TimeUnit.MILLISECONDS);
  }
}
