package tellosimulator.junit;

import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static tellosimulator.junit.TelloAssertions.assertThat;
import static tellosimulator.junit.Times.atLeast;
import static tellosimulator.junit.Times.times;

import java.io.IOException;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

@TelloTest(scenario = "gate-race", onCrash = OnCrash.ALLOW)
class DroneAssertTest {

  private final SimulatedDrone drone;

  DroneAssertTest(SimulatedDrone drone) {
    this.drone = drone;
  }

  @Test
  void aDroneThatStands() {
    assertThat(drone).neverTouchedAnything().neverCrashed().isWithin(1).ofStart();
    assertThat(drone).tookOff(times(0)).stayedBelow(1).stayedWithin(1).hasHeading(360, 1);

    says(
        "drone 1 has not landed: it stands at x -200, y -100, z 0 cm, and never took off",
        () -> assertThat(drone).hasLanded());
    says(
        "drone 1 is not flying: it stands at x -200, y -100, z 0 cm",
        () -> assertThat(drone).isFlying());
    says(
        "drone 1 has not crashed: it stands at x -200, y -100, z 0 cm",
        () -> assertThat(drone).hasCrashed());
    says(
        "drone 1: expected to take off at least 2 times, but did 0 times",
        () -> assertThat(drone).tookOff(atLeast(2)));
    says(
        "drone 1 should climb to 50 cm, but was only 0 cm high",
        () -> assertThat(drone).climbedTo(50));
    says(
        "drone 1 should look at 90 degrees, give or take 5, but looks at 0",
        () -> assertThat(drone).hasHeading(90, 5));
    says(
        "drone 1 should be within 10 cm of x 0, y 0 cm, but is 224 cm away, at x -200, y -100, z 0 cm",
        () -> assertThat(drone).isWithin(10).of(0, 0));
    says("drone 1 did not fly through B, but through none", () -> assertThat(drone).visited("B"));
    says(
        "[the pilot] drone 1 is not flying: it stands at x -200, y -100, z 0 cm",
        () -> assertThat(drone).as("the pilot").isFlying());
  }

  @Test
  void aDroneThatFlewThroughAGate() throws IOException {
    ScriptedOperator.fly(drone, "command", "takeoff", "up 70", "forward 200", "cw 90", "land");

    assertThat(drone).hasLanded().visited("A").climbedTo(99).hasHeading(90, 1);
    assertThat(drone).isWithin(1).of(0, -100);
    says(
        "drone 1 should stay below 90 cm, but was 100 cm high",
        () -> assertThat(drone).stayedBelow(90));
    says(
        "drone 1 should stay within 150 cm of its start, but was 200 cm away",
        () -> assertThat(drone).stayedWithin(150));
    says(
        "drone 1 should be within 20 cm of its start, but is 200 cm away, at x 0, y -100, z 0 cm",
        () -> assertThat(drone).isWithin(20).ofStart());
    says("drone 1 did not fly through C, but through A", () -> assertThat(drone).visited("C"));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> assertThat(drone).visited("D"))
        .withMessage("no gate is called D, the gates are A, B, C");
  }

  @Test
  void aDroneThatTouchedAWall() throws IOException {
    ScriptedOperator.fly(drone, "command", "takeoff", "back 100");

    assertThatThrownBy(() -> assertThat(drone).neverTouchedAnything())
        .hasMessageMatching(
            "drone 1 should touch nothing, but touched the back wall at \\d+\\.\\d s with \\d+ cm/s");
    assertThat(drone).neverCrashed();
  }

  private static void says(String sentence, ThrowingCallable assertion) {
    assertThatThrownBy(assertion).isInstanceOf(AssertionError.class).hasMessage(sentence);
  }
}
