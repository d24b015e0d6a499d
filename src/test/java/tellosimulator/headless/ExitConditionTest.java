package tellosimulator.headless;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.command.Peer;
import tellosimulator.command.Request;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.goal.Terms;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.testing.SimulatedDrones;
import tellosimulator.time.SimTime;

@Timeout(20)
class ExitConditionTest {

  private static final Goal FRONT =
      new Goal.Land(Terms.ANY, new GoalRegion(new Vec3(1, 0, 0), 0.1));

  private final GoalWatch goals =
      new GoalWatch(
          new Challenge(List.of(FRONT), false, OptionalDouble.of(60), false), event -> {});

  private static final ExitCondition.IdleLimits QUICK = new ExitCondition.IdleLimits(2, 4, 12);

  private static final Peer PROGRAM =
      new Peer(
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 9000),
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 8889));

  private int missed;

  private final ExitCondition exitCondition = new ExitCondition(goals, () -> missed++, QUICK);

  private final SimulatedDrones drones =
      new SimulatedDrones(SimConfig.DEFAULT, List.of(goals, exitCondition));

  @Test
  void theResultIsThatOfTheLastGoal() throws InterruptedException {
    drones.fly("command", "takeoff", "forward 100", "land");
    drones.advance(1);

    Progress result = exitCondition.awaitResult(NEVER);
    assertThat(result.status()).isEqualTo(Status.REACHED);
    assertThat(exitCondition.missed()).isFalse();
    exitCondition.awaitRest(NEVER);
  }

  @Test
  void whoLandsElsewhereHasMissedTheGoalsAfterFifteenSecondsOfSilence()
      throws InterruptedException {
    drones.fly("command", "takeoff", "land");
    double landed = goals.progress().elapsed();
    drones.advance(14.9);
    drones.fly("battery?");
    drones.advance(15.1);

    Progress result = exitCondition.awaitResult(NEVER);
    assertThat(result.status()).isEqualTo(Status.FAILED);
    assertThat(result.phrase().english())
        .endsWith(": all drones have landed, and no command came for 15 s");
    assertThat(result.elapsed() - landed).isCloseTo(29.9, within(0.02));
    assertThat(missed).as("reported once").isEqualTo(1);
    assertThat(exitCondition.missed()).isTrue();
    exitCondition.awaitRest(NEVER);
  }

  @Test
  void whereTimeStandsStillTheSilenceIsLetPass() throws InterruptedException {
    drones.fly("command", "takeoff", "land");
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.status()).isEqualTo(Status.FAILED);
    assertThat(result.count()).isZero();
    assertThat(standing.passed).containsExactly(15.0);
    assertThat(standing.looks).isLessThan(5);
    exitCondition.awaitRest(standing);
  }

  /** The drone lands by itself in the first 15 s, and no command arrives for 15 s after that. */
  @Test
  void aProgramThatGivesUpInTheAirIsWaitedForLonger() throws InterruptedException {
    drones.fly("command", "takeoff");
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.phrase().english()).contains("all drones have landed");
    assertThat(standing.passed).hasSizeBetween(2, 3);
    assertThat(standing.looks).isGreaterThan(12);
  }

  @Test
  void beforeTheFirstCommandItWaitsForEver() throws InterruptedException {
    Standing standing = new Standing();
    standing.most = 20;

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.status()).isEqualTo(Status.RUNNING);
    assertThat(standing.passed).isEmpty();
  }

  /** An example is a program whose takeoff command was lost. */
  @Test
  void aProgramThatFallsSilentBeforeItsTakeoffHasMissedTheGoals() throws InterruptedException {
    drones.fly("command");
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.phrase().english())
        .endsWith(": no drone took off, and no command came for 60 s");
    assertThat(standing.passed).containsExactly(60.0);
    assertThat(standing.looks).isBetween(12, 16);
  }

  @Test
  void aProgramThatAsksBeforeItsTakeoffIsNotSilent() throws InterruptedException {
    drones.fly("command");
    for (int i = 0; i < 3; i++) {
      drones.advance(59);
      drones.fly("battery?");
    }
    Standing standing = new Standing();
    standing.most = 5;

    assertThat(exitCondition.awaitResult(standing).status()).isEqualTo(Status.RUNNING);
  }

  @Test
  void aTimeoutEndsProgramsThatNeverTakeOff() throws InterruptedException {
    exitCondition.limit(Optional.of(20.0), false);
    drones.fly("command");
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.phrase().english())
        .isEqualTo("goals: 0 of 1 reached after 0.0 s: no drone took off within 20 s");
    assertThat(standing.passed).containsExactly(20.0);
    assertThat(standing.looks).isBetween(4, 8);
  }

  /** An interpreter loads its libraries before the program sends anything. */
  @Test
  void aProgramThatStartsSlowlyIsWaitedForLongerThanOneThatHasSpoken() throws InterruptedException {
    exitCondition.limit(Optional.of(20.0), false);
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.phrase().english()).endsWith(": no drone took off within 20 s");
    assertThat(standing.looks).isGreaterThanOrEqualTo(12);
  }

  /** The time for which it has not sent anything yet must not count as silence afterwards. */
  @Test
  void aProgramThatHasStartedSlowlyHasTheWholeTimeUntilItsTakeoff() throws InterruptedException {
    exitCondition.limit(Optional.of(20.0), false);
    Standing standing = new Standing();
    standing.speaks = 8;

    exitCondition.awaitResult(standing);

    assertThat(standing.looksUntilPassing).isEqualTo(12);
  }

  @Test
  void aProgramThatIsRunMayPauseBeforeItsTakeoff() throws InterruptedException {
    exitCondition.limit(Optional.of(20.0), true);
    drones.fly("command");
    Standing standing = new Standing();

    exitCondition.awaitResult(standing);

    assertThat(standing.looksUntilPassing).isGreaterThanOrEqualTo(12);
  }

  @Test
  void aProgramThatNeverSendsAnythingHasMissedTheGoals() throws InterruptedException {
    exitCondition.limit(Optional.empty(), true);
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.phrase().english())
        .isEqualTo("goals: 0 of 1 reached after 0.0 s: no command came for 120 s");
    assertThat(standing.passed).containsExactly(120.0);
  }

  @Test
  void aTimeoutEndsProgramsThatFlyForEver() throws InterruptedException {
    exitCondition.limit(Optional.of(20.0), false);
    drones.fly("command", "takeoff");
    for (int i = 0; i < 10; i++) {
      drones.fly("battery?");
      drones.advance(2);
    }

    Progress result = exitCondition.awaitResult(NEVER);

    assertThat(result.status()).isEqualTo(Status.FAILED);
    assertThat(result.phrase().english()).endsWith(": the timeout of 20 s is over");
  }

  /** The drone lands in 2 s; by itself it would do so after 15 s of silence. */
  @Test
  void whenTheProgramEndsItsDroneLandsAndTheVerdictFollows() throws InterruptedException {
    drones.fly("command", "takeoff");
    drones.control(new Control.Land(1));
    exitCondition.finish();
    drones.advance(5);

    Progress result = exitCondition.awaitResult(NEVER);
    assertThat(result.phrase().english())
        .endsWith(": the program ended while drone 1 was in the air");
    exitCondition.awaitRest(NEVER);
  }

  @Test
  void aProgramThatEndsBeforeItsFirstCommandHasMissedTheGoals() throws InterruptedException {
    exitCondition.finish();
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.phrase().english())
        .isEqualTo("goals: 0 of 1 reached after 0.0 s: the program has ended");
    assertThat(standing.looks).isLessThan(5);
    exitCondition.awaitRest(standing);
  }

  @Test
  void goalsThatAreReachedStaySoWhenTheProgramEnds() throws InterruptedException {
    drones.fly("command", "takeoff", "forward 100", "land");
    exitCondition.finish();
    drones.advance(1);

    assertThat(exitCondition.awaitResult(NEVER).status()).isEqualTo(Status.REACHED);
  }

  /** The drone has begun to take off, but is still on the ground. */
  @Test
  void aDroneThatIsAboutToTakeOffStaysOnTheGround() throws InterruptedException {
    drones.fly("command");
    drones.send(1, "takeoff");
    drones.control(new Control.Land(1));
    exitCondition.finish();
    drones.advance(1);

    assertThat(exitCondition.awaitResult(NEVER).phrase().english())
        .endsWith(": the program ended while drone 1 was in the air");
    exitCondition.awaitRest(NEVER);
  }

  @Test
  void aDroneThatStaysInTheAirIsWaitedForForTenSeconds() throws InterruptedException {
    GoalWatch over =
        new GoalWatch(
            new Challenge(List.of(FRONT), false, OptionalDouble.of(5), false), event -> {});
    ExitCondition late = new ExitCondition(over, () -> {}, QUICK);
    SimulatedDrones flying = new SimulatedDrones(SimConfig.DEFAULT, List.of(over, late));
    flying.fly("command", "takeoff");
    flying.advance(16);

    Progress result = late.awaitResult(NEVER);
    assertThat(result.status()).isEqualTo(Status.FAILED);
    assertThat(result.elapsed()).isCloseTo(5, within(0.01));
    late.awaitRest(NEVER);
  }

  /** Simulated time that advances with the wall clock. */
  private static final ExitCondition.Standstill NEVER =
      new ExitCondition.Standstill() {
        @Override
        public boolean possible() {
          return false;
        }

        @Override
        public void pass(double seconds) {
          throw new AssertionError("time passes by itself");
        }
      };

  /**
   * Simulated time that stands still. Counts the checks, and ends the waiting after a number of
   * them.
   */
  private final class Standing implements ExitCondition.Standstill {

    private final List<Double> passed = new ArrayList<>();
    private int most = 100;
    private int looks;

    /** The look at which a program sends its first command. */
    private int speaks = -1;

    private int looksUntilPassing;

    @Override
    public boolean possible() {
      looks++;
      if (looks == speaks) {
        exitCondition.event(
            new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(1, PROGRAM, "command")));
      }
      if (looks > most) {
        exitCondition.now();
      }
      return true;
    }

    @Override
    public void pass(double seconds) {
      if (passed.isEmpty()) {
        looksUntilPassing = looks;
      }
      passed.add(seconds);
      drones.advance(seconds + 0.005);
    }
  }
}
