package tellosimulator.recording;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.goal.Terms;
import tellosimulator.json.Json;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimConfig;

class InputHistoryTest {

  private static final InitialConditions START =
      new InitialConditions(SimConfig.DEFAULT, Challenge.NONE, OptionalInt.empty());

  private final InputHistory inputs = new InputHistory();

  @Test
  void goalsThatAreAskedForLaterTakeThePlaceOfTheFirst() {
    Goal goal = new Goal.Reach(Terms.ANY, new GoalRegion(new Vec3(0, 0, 0.5), 0.1));
    Challenge asked = Challenge.NONE.withGoals(List.of(goal));
    inputs.take(new Entry.NewRun(Optional.of(START)));
    assertThat(inputs.text()).isEqualTo(InputHistory.line(START));

    inputs.take(new Entry.Asked(asked));

    assertThat(inputs.text())
        .isEqualTo(InputHistory.line(START.withChallenge(asked)))
        .isNotEqualTo(InputHistory.line(START));
    assertThat(inputs.complete()).isTrue();
  }

  @Test
  void theTermsOfAGoalAreItsMembersAsInEarlierVersions() {
    GoalRegion region = new GoalRegion(new Vec3(0, 0, 0.5), 0.1);
    Goal plain = new Goal.Reach(Terms.of(2), region);
    Goal worth = new Goal.Land(Terms.ANY.worth(2.5), region);
    Goal poster = new Goal.See(Terms.of(1), new Goal.NamedPoster("cat"));
    Goal pad = new Goal.See(Terms.ANY.worth(5), new Goal.NumberedPad(3), 25, 2);
    InitialConditions start =
        START.withChallenge(Challenge.NONE.withGoals(List.of(plain, worth, poster, pad)));

    String line = InputHistory.line(start);

    assertThat(line)
        .contains("{\"type\": \"Reach\", \"drone\": 2, \"region\": {")
        .contains("{\"type\": \"Land\", \"points\": 2.5, \"region\": {")
        .doesNotContain("terms");
    assertThat(InitialConditions.of(Json.value(line))).isEqualTo(start);
  }

  @Test
  void ofAnIncompleteHistoryNothingIsLeft() {
    inputs.take(new Entry.NewRun(Optional.of(START)));

    inputs.take(new Entry.Missed());

    assertThat(inputs.text()).isEmpty();
    assertThat(inputs.complete()).isFalse();
  }
}
