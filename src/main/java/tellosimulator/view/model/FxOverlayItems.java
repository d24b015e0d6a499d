package tellosimulator.view.model;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Progress;
import tellosimulator.scenery.overlay.ContactDecal;
import tellosimulator.world.Arena;

/**
 * The items drawn over the room: the goals, and the places of contacts and crashes. Confined to the
 * JavaFX thread.
 */
public final class FxOverlayItems {

  private final Supplier<Progress> progress;
  private final Supplier<List<ContactDecal>> contacts;
  private Challenge challenge = Challenge.NONE;
  private List<GoalState> states = List.of();
  private Arena arena = Arena.DEFAULT;
  private List<PlacedGoal> goals = List.of();

  /**
   * @param progress supplies the drones' progress
   * @param contacts supplies the drones' contacts
   */
  public FxOverlayItems(Supplier<Progress> progress, Supplier<List<ContactDecal>> contacts) {
    this.progress = progress;
    this.contacts = contacts;
  }

  /**
   * Returns the goals with their places in a room. The same list is returned until a goal, its
   * state or the room changes.
   */
  public List<PlacedGoal> goals(Arena present) {
    Progress now = progress.get();
    List<GoalState> newest = IntStream.range(0, now.reached().size()).mapToObj(now::state).toList();
    if (!newest.equals(states) || !present.equals(arena) || !now.challenge().equals(challenge)) {
      challenge = now.challenge();
      arena = present;
      states = newest;
      goals = PlacedGoal.of(now, present);
    }
    return goals;
  }

  /** Returns whether the challenge has any goals. */
  public boolean asked() {
    return !progress.get().challenge().goals().isEmpty();
  }

  /** Returns the places where drones touched something or crashed, oldest first. */
  public List<ContactDecal> contacts() {
    return contacts.get();
  }
}
