package tellosimulator.view.plan;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import tellosimulator.math.Vec3;

/** A line on which several items are aligned. The front wall is at the top of the plan. */
enum Alignment {
  /** The front edges, at the top of the plan. */
  FRONT(true, edges -> edges.getMax()),
  BACK(true, edges -> edges.getMin()),
  LEFT(false, edges -> edges.getMax()),
  RIGHT(false, edges -> edges.getMin()),
  /** The middles of the items, which then form a row from left to right. */
  ROW(true, Alignment::middle),
  /** The middles of the items, which then form a column from front to back. */
  COLUMN(false, Alignment::middle);

  private final boolean alongX;
  private final ToDoubleFunction<DoubleSummaryStatistics> line;

  /**
   * Creates an alignment along an axis.
   *
   * @param alongX whether items are moved along the room's x axis rather than its y axis
   * @param line returns the position of the line, given the edges of an item along that axis [m]
   */
  Alignment(boolean alongX, ToDoubleFunction<DoubleSummaryStatistics> line) {
    this.alongX = alongX;
    this.line = line;
  }

  private static double middle(DoubleSummaryStatistics edges) {
    return (edges.getMin() + edges.getMax()) / 2;
  }

  /** Returns the suffix of this alignment's text keys. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns the plan with the given items aligned with the last of them. */
  FloorPlan aligned(FloorPlan plan, List<PlanItem> items) {
    if (items.isEmpty()) {
      return plan;
    }
    double wanted = line(plan, items.get(items.size() - 1));
    FloorPlan aligned = plan;
    for (PlanItem item : items) {
      double way = wanted - line(plan, item);
      Placement now = plan.placement(item);
      Vec3 moved = now.place().plus(alongX ? new Vec3(way, 0, 0) : new Vec3(0, way, 0));
      aligned = aligned.with(item, now.at(moved));
    }
    return aligned;
  }

  private double line(FloorPlan plan, PlanItem item) {
    return line.applyAsDouble(
        plan.outline(item).corners(plan.placement(item)).stream()
            .mapToDouble(corner -> alongX ? corner.x() : corner.y())
            .summaryStatistics());
  }
}
