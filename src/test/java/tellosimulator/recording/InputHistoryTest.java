package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimConfig;

class InputHistoryTest {

  private static final InitialConditions START =
      new InitialConditions(SimConfig.DEFAULT, Challenge.NONE, OptionalInt.empty());

  private final InputHistory inputs = new InputHistory();

  @Test
  void goalsThatAreAskedForLaterTakeThePlaceOfTheFirst() {
    Goal goal = new Goal.Reach(OptionalInt.empty(), new GoalRegion(new Vec3(0, 0, 0.5), 0.1));
    Challenge asked = Challenge.NONE.withGoals(List.of(goal));
    inputs.take(new Entry.Anew(Optional.of(START)));
    assertThat(inputs.text()).isEqualTo(InputLines.text(START));

    inputs.take(new Entry.Asked(asked));

    assertThat(inputs.text())
        .isEqualTo(InputLines.text(START.withChallenge(asked)))
        .isNotEqualTo(InputLines.text(START));
    assertThat(inputs.complete()).isTrue();
  }

  @Test
  void ofAnIncompleteHistoryNothingIsLeft() {
    inputs.take(new Entry.Anew(Optional.of(START)));

    inputs.take(new Entry.Missed());

    assertThat(inputs.text()).isEmpty();
    assertThat(inputs.complete()).isFalse();
  }
}
