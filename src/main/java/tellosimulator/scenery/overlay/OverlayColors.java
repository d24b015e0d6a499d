package tellosimulator.scenery.overlay;

import java.util.function.IntFunction;
import tellosimulator.goal.GoalState;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.scenery.mesh.Rgb;

/**
 * The colours of goals and contacts. They are the same in the room, on the plan and in reports.
 *
 * <p>Decided: the colours that the window's theme (Primer) uses for success, accent, disabled and
 * danger. The goal panel and the log use them with the same meanings.
 */
public final class OverlayColors {

  /** The colour of contacts and crashes. */
  public static final Rgb CONTACT = Rgb.of(0xcf222e);

  private static final Rgb DONE = Rgb.of(0x1a7f37);
  private static final Rgb ACTIVE = Rgb.of(0x0969da);
  private static final Rgb LATER = Rgb.of(0x6e7781);

  private OverlayColors() {}

  /** Returns the colour of a goal that may be reached by any drone. */
  public static Rgb of(GoalState state) {
    return switch (state) {
      case DONE -> DONE;
      case ACTIVE -> ACTIVE;
      case LATER -> LATER;
    };
  }

  /**
   * Returns the colour of a goal. If one particular drone must reach it, the goal has that drone's
   * colour until it is reached.
   *
   * @param drones returns the colour of a drone by its number
   */
  public static Rgb of(PlacedGoal mark, IntFunction<Rgb> drones) {
    boolean own = mark.drone().isPresent() && mark.state() != GoalState.DONE;
    return own ? drones.apply(mark.drone().getAsInt()) : of(mark.state());
  }
}
