package tellosimulator.scenery.overlay;

import java.util.function.IntFunction;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.GoalState;
import tellosimulator.scenery.mesh.Rgb;

/**
 * The colours of goals and contacts: the same in the room, in the plan and in reports.
 *
 * <p>Decided: those of the window's theme (Primer) for success, accent, what is disabled, and
 * danger, in which the goal panel and the log write of the same things.
 */
public final class MarkColors {

  /** Where a drone touched something or crashed. */
  public static final Rgb CONTACT = Rgb.of(0xcf222e);

  private static final Rgb DONE = Rgb.of(0x1a7f37);
  private static final Rgb ACTIVE = Rgb.of(0x0969da);
  private static final Rgb LATER = Rgb.of(0x6e7781);

  private MarkColors() {}

  /** That of a goal that any drone may reach. */
  public static Rgb of(GoalState state) {
    return switch (state) {
      case DONE -> DONE;
      case ACTIVE -> ACTIVE;
      case LATER -> LATER;
    };
  }

  /**
   * That of a goal: until it is reached, the colour of the drone that shall reach it.
   *
   * @param drones the colour of the drone of a number
   */
  public static Rgb of(GoalMark mark, IntFunction<Rgb> drones) {
    boolean own = mark.drone().isPresent() && mark.state() != GoalState.DONE;
    return own ? drones.apply(mark.drone().getAsInt()) : of(mark.state());
  }
}
