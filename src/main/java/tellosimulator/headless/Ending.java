package tellosimulator.headless;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.SimTime;

/**
 * Waits until goals are reached or missed, and the drones have come down, so that no program loses
 * its drone on the way to the ground.
 */
final class Ending implements SimListener {

  /** Longest time that drones may stay in the air [s]. Decided: time to fly back and land. */
  private static final double LONGEST_FLIGHT = 10;

  /** How long the last replies may take after that [s]. Measured: at most 0.05 s. */
  private static final double REPLIES = 0.1;

  /** The same where simulated time stands still, because nothing moves any more [ms]. */
  private static final int REPLIES_MS = 500;

  /**
   * How long simulated time may stand still after the first takeoff, where it does so because
   * nothing moves [ms]. Decided: twice as long as a drone waits for a command before it lands.
   */
  private static final int STANDSTILL_MS = 30_000;

  private final GoalWatch goals;
  private final int patienceMs;
  private final AtomicLong steps = new AtomicLong();
  private final CountDownLatch result = new CountDownLatch(1);
  private final CountDownLatch landed = new CountDownLatch(1);
  private final CountDownLatch answered = new CountDownLatch(1);
  private volatile Optional<Progress> progress = Optional.empty();
  private Optional<SimTime> resultAt = Optional.empty();
  private Optional<SimTime> landedAt = Optional.empty();

  /**
   * @param goals is told of each step before
   */
  Ending(GoalWatch goals) {
    this(goals, STANDSTILL_MS);
  }

  /**
   * @param patienceMs how long simulated time may stand still [ms]
   */
  Ending(GoalWatch goals, int patienceMs) {
    this.goals = goals;
    this.patienceMs = patienceMs;
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    SimTime now = snapshot.time();
    steps.incrementAndGet();
    if (resultAt.isEmpty() && goals.progress().status() == Status.RUNNING) {
      return;
    }
    if (resultAt.isEmpty()) {
      resultAt = Optional.of(now);
      progress = Optional.of(goals.progress());
    }
    result.countDown();
    if (landedAt.isPresent() || down(snapshot) || now.since(resultAt.get()) > LONGEST_FLIGHT) {
      landedAt = Optional.of(landedAt.orElse(now));
      landed.countDown();
      if (now.since(landedAt.get()) >= REPLIES) {
        answered.countDown();
      }
    }
  }

  private static boolean down(SimSnapshot snapshot) {
    return snapshot.drones().stream().noneMatch(drone -> drone.state().phase().flying());
  }

  /** Waits no longer. */
  void now() {
    result.countDown();
    landed.countDown();
    answered.countDown();
  }

  /**
   * Waits for the result, which stays the same whatever happens afterwards. Where nothing moves any
   * more, it is what was reached until then.
   *
   * @param asNeeded whether simulated time passes only while something moves
   */
  Progress awaitResult(BooleanSupplier asNeeded) throws InterruptedException {
    await(result, asNeeded);
    return progress.orElseGet(goals::progress);
  }

  /**
   * Waits for the drones and their last replies.
   *
   * @param asNeeded whether simulated time passes only while something moves
   */
  @SuppressWarnings("ReturnValueIgnored") // whichever comes first
  void awaitRest(BooleanSupplier asNeeded) throws InterruptedException {
    await(landed, asNeeded);
    answered.await(REPLIES_MS, TimeUnit.MILLISECONDS);
  }

  /** Waits, but not for a moment to which time never comes. */
  private void await(CountDownLatch latch, BooleanSupplier asNeeded) throws InterruptedException {
    long before = -1;
    while (!latch.await(patienceMs, TimeUnit.MILLISECONDS)) {
      long count = steps.get();
      boolean begun = goals.progress().elapsed() > 0;
      if (begun && count == before && asNeeded.getAsBoolean()) {
        return;
      }
      before = count;
    }
  }
}
