package tellosimulator.view.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.math.Vec3;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.scenery.overlay.ContactDecal;
import tellosimulator.view.model.FxOverlayItems;

/**
 * In the recorded flight, the first goal is reached at 10.5 s, and the pole is touched at 9.5 s.
 */
class ReplayOverlayTest {

  private static final String SCENARIO =
      """
      room: {width: 500, depth: 600, height: 300}
      pads: [{id: 3, at: [100, 0]}]
      goals:
        - reach: {at: [0, 50, 80]}
        - land-on: {pad: 3}
      in-order: true
      """;

  @TempDir private Path folder;

  @BeforeEach
  void record() {
    RecordingFixture.in(folder);
  }

  @Test
  void whatIsMarkedIsThatOfTheMomentForwardAndBack() throws UnreadableRecordingException {
    new RecordingFixture(folder).with("scenario.yaml", SCENARIO);
    FxReplay replay = new FxReplay(ReplayFlight.read(folder));
    FxOverlayItems marks = ReplayOverlay.of(replay);

    replay.playback().seek(9.4);
    assertThat(states(marks, replay)).containsExactly(GoalState.ACTIVE, GoalState.LATER);
    assertThat(marks.contacts()).isEmpty();

    replay.playback().seek(9.5);
    assertThat(marks.contacts())
        .containsExactly(new ContactDecal(1, new Vec3(-0.5, 0.5, 0.8), false));

    replay.playback().seek(10.5);
    assertThat(states(marks, replay)).containsExactly(GoalState.DONE, GoalState.ACTIVE);

    replay.playback().seek(5);
    assertThat(states(marks, replay)).containsExactly(GoalState.ACTIVE, GoalState.LATER);
    assertThat(marks.contacts()).isEmpty();
  }

  @Test
  void aRecordingWithoutAScenarioHasNoGoalsButContacts() throws UnreadableRecordingException {
    FxReplay replay = new FxReplay(ReplayFlight.read(folder));
    FxOverlayItems marks = ReplayOverlay.of(replay);

    replay.playback().seek(15);

    assertThat(marks.asked()).isFalse();
    assertThat(marks.contacts()).hasSize(1);
  }

  @Test
  void goalsOfWhichNothingIsSaidAreOpen() throws UnreadableRecordingException {
    new RecordingFixture(folder).with("scenario.yaml", SCENARIO).with("goals.json", "[]");
    FxReplay replay = new FxReplay(ReplayFlight.read(folder));

    replay.playback().seek(15);

    assertThat(states(ReplayOverlay.of(replay), replay))
        .containsExactly(GoalState.ACTIVE, GoalState.LATER);
  }

  private static List<GoalState> states(FxOverlayItems marks, FxReplay replay) {
    return marks.goals(replay.flight().snapshots().at(replay.playback().time()).arena()).stream()
        .map(PlacedGoal::state)
        .toList();
  }
}
