package tellosimulator.view.model;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.Progress;
import tellosimulator.scenery.overlay.ContactMark;
import tellosimulator.world.Arena;

/**
 * What is marked in pictures of the room: the goals, and where drones touched something or crashed.
 * For the JavaFX thread.
 */
public final class FxMarks {

  private final Supplier<Progress> progress;
  private final Supplier<List<ContactMark>> contacts;
  private Challenge challenge = Challenge.NONE;
  private List<GoalState> states = List.of();
  private Arena arena = Arena.DEFAULT;
  private List<GoalMark> goals = List.of();

  /**
   * @param progress how far the drones have come
   * @param contacts what they have touched
   */
  public FxMarks(Supplier<Progress> progress, Supplier<List<ContactMark>> contacts) {
    this.progress = progress;
    this.contacts = contacts;
  }

  /** The goals in a room; the same list as before until something becomes another one. */
  public List<GoalMark> goals(Arena present) {
    Progress now = progress.get();
    List<GoalState> newest = IntStream.range(0, now.reached().size()).mapToObj(now::state).toList();
    if (!newest.equals(states) || !present.equals(arena) || !now.challenge().equals(challenge)) {
      challenge = now.challenge();
      arena = present;
      states = newest;
      goals = GoalMark.of(now, present);
    }
    return goals;
  }

  /** Whether there is any goal. */
  public boolean asked() {
    return !progress.get().challenge().goals().isEmpty();
  }

  /** Where drones touched something or crashed, the oldest first. */
  public List<ContactMark> contacts() {
    return contacts.get();
  }
}
