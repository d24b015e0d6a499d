package tellosimulator.view.plan;

import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.function.Function;
import tellosimulator.math.Vec3;

/** Looks for a place where something new can be: beside what is there, or else where it fits. */
final class FreePlace {

  /** Distance between places at which something new is tried [m]. Decided. */
  private static final double GRID_STEP = 0.25;

  /** How far from a place something new is tried, in rasters. Decided: seven metres. */
  private static final int MOST_RINGS = 28;

  /** What stays free around something new [m]. Decided: its name and that of its neighbour. */
  private static final double AIR = 0.15;

  private FreePlace() {}

  /**
   * The plan with something new, as near as can be to a place.
   *
   * @param item the new one
   * @param adding makes the plan with it at a place of the floor
   * @return empty if it fits nowhere
   */
  static Optional<FloorPlan> near(Vec3 near, PlanItem item, Function<Vec3, FloorPlan> adding) {
    return around(near, item, adding, FreePlace::apart)
        .or(() -> around(near, item, adding, (wanted, other) -> true));
  }

  /** Tries places around one, from the nearest ring to the farthest. */
  private static Optional<FloorPlan> around(
      Vec3 near,
      PlanItem item,
      Function<Vec3, FloorPlan> adding,
      BiPredicate<FloorPlan, PlanItem> wish) {
    for (int ring = 0; ring <= MOST_RINGS; ring++) {
      for (int x = -ring; x <= ring; x++) {
        for (int y = -ring; y <= ring; y++) {
          if (Math.max(Math.abs(x), Math.abs(y)) == ring) {
            Vec3 place = near.plus(new Vec3(x * GRID_STEP, y * GRID_STEP, 0)).withZ(0);
            FloorPlan wanted = adding.apply(place);
            if (PlacementProblem.problem(wanted, item).isEmpty() && wish.test(wanted, item)) {
              return Optional.of(wanted);
            }
          }
        }
      }
    }
    return Optional.empty();
  }

  /** Whether a new item is clear of all others, however they are turned. */
  private static boolean apart(FloorPlan wanted, PlanItem item) {
    Vec3 place = wanted.placement(item).place();
    double reach = wanted.outline(item).reach() + AIR;
    return wanted.items().stream()
        .filter(other -> !other.equals(item))
        .noneMatch(other -> wanted.outline(other).covers(place, wanted.placement(other), reach));
  }
}
