package tellosimulator.headless;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalWatch;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Progress.Status;
import tellosimulator.goal.Spot;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimConfig;
import tellosimulator.testing.SimulatedDrones;

@Timeout(20)
class EndingTest {

  private static final Goal FRONT =
      new Goal.Land(OptionalInt.empty(), new Spot(new Vec3(1, 0, 0), 0.1));

  private final GoalWatch goals =
      new GoalWatch(
          new Challenge(List.of(FRONT), false, OptionalDouble.of(60), false), event -> {});

  private final Ending ending = new Ending(goals, 1);

  private final SimulatedDrones drones =
      new SimulatedDrones(SimConfig.DEFAULT, List.of(goals, ending));

  @Test
  void theResultIsThatOfTheLastGoal() throws InterruptedException {
    drones.fly("command", "takeoff", "forward 100", "land");
    drones.advance(1);

    Progress result = ending.awaitResult(() -> false);
    assertThat(result.status()).isEqualTo(Status.REACHED);
    ending.awaitRest(() -> false);
  }

  @Test
  void whoLandsElsewhereWhereTimeStandsStillHasMissedTheGoals() throws InterruptedException {
    drones.fly("command", "takeoff", "land");

    Progress result = ending.awaitResult(() -> true);
    assertThat(result.status()).isEqualTo(Status.RUNNING);
    assertThat(result.count()).isZero();
    ending.awaitRest(() -> true);
  }

  @Test
  void aPausedTimeIsWaitedFor() throws InterruptedException {
    drones.fly("command", "takeoff", "land");
    int[] looks = {0};

    ending.awaitResult(() -> ++looks[0] > 3);

    assertThat(looks[0]).isEqualTo(4);
  }

  @Test
  void aDroneThatStaysInTheAirIsWaitedForForTenSeconds() throws InterruptedException {
    GoalWatch over =
        new GoalWatch(
            new Challenge(List.of(FRONT), false, OptionalDouble.of(5), false), event -> {});
    Ending late = new Ending(over, 1);
    SimulatedDrones flying = new SimulatedDrones(SimConfig.DEFAULT, List.of(over, late));
    flying.fly("command", "takeoff");
    flying.advance(16);

    Progress result = late.awaitResult(() -> false);
    assertThat(result.status()).isEqualTo(Status.FAILED);
    assertThat(result.elapsed()).isCloseTo(5, within(0.01));
    late.awaitRest(() -> false);
  }
}
