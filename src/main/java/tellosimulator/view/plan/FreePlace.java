package tellosimulator.view.plan;

import java.util.Optional;
import java.util.function.Predicate;
import tellosimulator.math.Vec3;

/** Finds a place for a new item: beside existing items if possible, otherwise wherever it fits. */
final class FreePlace {

  /** Distance between candidate places [m]. Decided. */
  private static final double GRID_STEP = 0.25;

  /** Number of grid steps that are searched in each direction. Decided: reaches 7 m. */
  private static final int MOST_RINGS = 28;

  /**
   * Space to keep free around a new item if possible [m]. Decided: leaves space for the names of
   * the item and its neighbour.
   */
  private static final double AIR = 0.15;

  private FreePlace() {}

  /**
   * Returns the plan with a new item near a place: at the nearest place that is clear of other
   * items, or else at the nearest place where the item fits; empty if there is none.
   *
   * @param added the plan with the item at any place
   */
  static Optional<FloorPlan> near(Vec3 near, PlanChange added) {
    return around(near, added, wanted -> apart(wanted, added.item()))
        .or(() -> around(near, added, wanted -> true));
  }

  /** Tries the places around a given one, from the innermost ring outwards. */
  private static Optional<FloorPlan> around(
      Vec3 near, PlanChange added, Predicate<FloorPlan> wish) {
    for (int ring = 0; ring <= MOST_RINGS; ring++) {
      for (int x = -ring; x <= ring; x++) {
        for (int y = -ring; y <= ring; y++) {
          if (Math.max(Math.abs(x), Math.abs(y)) == ring) {
            FloorPlan wanted = added.at(near.plus(new Vec3(x * GRID_STEP, y * GRID_STEP, 0)));
            if (PlacementProblem.problem(wanted, added.item()).isEmpty() && wish.test(wanted)) {
              return Optional.of(wanted);
            }
          }
        }
      }
    }
    return Optional.empty();
  }

  /** Returns whether a new item is clear of all others, regardless of its rotation. */
  private static boolean apart(FloorPlan wanted, PlanItem item) {
    Vec3 place = wanted.placement(item).place();
    double reach = wanted.outline(item).reach() + AIR;
    return wanted.items().stream()
        .filter(other -> !other.equals(item))
        .noneMatch(other -> wanted.outline(other).covers(place, wanted.placement(other), reach));
  }
}
