package tellosimulator.headless;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
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

  private final GoalWatch goals;
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
    this.goals = goals;
  }

  @Override
  public void stepped(SimSnapshot snapshot) {
    SimTime now = snapshot.time();
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

  /** Waits for the result, which stays the same whatever happens afterwards. */
  Progress awaitResult() throws InterruptedException {
    result.await();
    return progress.orElseGet(goals::progress);
  }

  /** Waits for the drones and their last replies. */
  @SuppressWarnings("ReturnValueIgnored") // whichever comes first
  void awaitRest() throws InterruptedException {
    landed.await();
    answered.await(REPLIES_MS, TimeUnit.MILLISECONDS);
  }
}
