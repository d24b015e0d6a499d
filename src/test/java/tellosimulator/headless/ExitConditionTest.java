package tellosimulator.headless;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SimulatedDrones;

@Timeout(20)
class ExitConditionTest {

  private static final Goal FRONT =
      new Goal.Land(OptionalInt.empty(), new GoalRegion(new Vec3(1, 0, 0), 0.1));

  private final GoalWatch goals =
      new GoalWatch(
          new Challenge(List.of(FRONT), false, OptionalDouble.of(60), false), event -> {});

  private static final ExitCondition.IdleLimits QUICK = new ExitCondition.IdleLimits(2, 4, 12);

  private final ExitCondition exitCondition = new ExitCondition(goals, QUICK);

  private final SimulatedDrones drones =
      new SimulatedDrones(SimConfig.DEFAULT, List.of(goals, exitCondition));

  @Test
  void theResultIsThatOfTheLastGoal() throws InterruptedException {
    drones.fly("command", "takeoff", "forward 100", "land");
    drones.advance(1);

    Progress result = exitCondition.awaitResult(NEVER);
    assertThat(result.status()).isEqualTo(Status.REACHED);
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

  /** It lands by itself in the first 15 s, and is silent for 15 s after that. */
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

  /** Such as one whose takeoff was lost on the way. */
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
    exitCondition.limit(Optional.of(20.0));
    drones.fly("command");
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.phrase().english())
        .isEqualTo("goals: 0 of 1 reached after 0.0 s: no drone took off within 20 s");
    assertThat(standing.passed).containsExactly(20.0);
    assertThat(standing.looks).isBetween(4, 8);
  }

  /** An interpreter loads its libraries before it says its first word. */
  @Test
  void aProgramThatStartsSlowlyIsWaitedForLongerThanOneThatHasSpoken() throws InterruptedException {
    exitCondition.limit(Optional.of(20.0));
    Standing standing = new Standing();

    Progress result = exitCondition.awaitResult(standing);

    assertThat(result.phrase().english()).endsWith(": no drone took off within 20 s");
    assertThat(standing.looks).isGreaterThanOrEqualTo(12);
  }

  @Test
  void aTimeoutEndsProgramsThatFlyForEver() throws InterruptedException {
    exitCondition.limit(Optional.of(20.0));
    drones.fly("command", "takeoff");
    for (int i = 0; i < 10; i++) {
      drones.fly("battery?");
      drones.advance(2);
    }

    Progress result = exitCondition.awaitResult(NEVER);

    assertThat(result.status()).isEqualTo(Status.FAILED);
    assertThat(result.phrase().english()).endsWith(": the timeout of 20 s is over");
  }

  /** The drone lands in 2 s; by itself it would after 15 s of silence. */
  @Test
  void whenTheProgramEndsItsDroneLandsAndTheVerdictFollows() throws InterruptedException {
    drones.fly("command", "takeoff");
    drones.control(new Control.Land(1));
    exitCondition.finish();
    double begun = goals.progress().elapsed();
    drones.advance(5);

    Progress result = exitCondition.awaitResult(NEVER);
    assertThat(result.phrase().english()).endsWith(": the program has ended");
    assertThat(result.elapsed() - begun).isBetween(1.0, 4.0);
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

  /** A takeoff is under way, but nothing has left the ground yet. */
  @Test
  void aDroneThatIsAboutToTakeOffStaysOnTheGround() throws InterruptedException {
    drones.fly("command");
    drones.send(1, "takeoff");
    drones.control(new Control.Land(1));
    exitCondition.finish();
    drones.advance(1);

    assertThat(exitCondition.awaitResult(NEVER).phrase().english())
        .endsWith(": the program has ended");
    exitCondition.awaitRest(NEVER);
  }

  @Test
  void aDroneThatStaysInTheAirIsWaitedForForTenSeconds() throws InterruptedException {
    GoalWatch over =
        new GoalWatch(
            new Challenge(List.of(FRONT), false, OptionalDouble.of(5), false), event -> {});
    ExitCondition late = new ExitCondition(over, QUICK);
    SimulatedDrones flying = new SimulatedDrones(SimConfig.DEFAULT, List.of(over, late));
    flying.fly("command", "takeoff");
    flying.advance(16);

    Progress result = late.awaitResult(NEVER);
    assertThat(result.status()).isEqualTo(Status.FAILED);
    assertThat(result.elapsed()).isCloseTo(5, within(0.01));
    late.awaitRest(NEVER);
  }

  /** Time that passes by the clock. */
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

  /** Time that stands still; counts how often that was asked, and ends the waiting some time. */
  private final class Standing implements ExitCondition.Standstill {

    private final List<Double> passed = new ArrayList<>();
    private int most = 100;
    private int looks;

    @Override
    public boolean possible() {
      looks++;
      if (looks > most) {
        exitCondition.now();
      }
      return true;
    }

    @Override
    public void pass(double seconds) {
      passed.add(seconds);
      drones.advance(seconds + 0.005);
    }
  }
}
