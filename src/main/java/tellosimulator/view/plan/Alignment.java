package tellosimulator.view.plan;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import tellosimulator.math.Vec3;

/** A line to which several items are moved; the plan shows the front wall above. */
enum Alignment {
  /** The front edges, which are the upper ones of the plan. */
  FRONT(true, edges -> edges.getMax()),
  BACK(true, edges -> edges.getMin()),
  LEFT(false, edges -> edges.getMax()),
  RIGHT(false, edges -> edges.getMin()),
  /** The middles, in a row from left to right. */
  ROW(true, Alignment::middle),
  /** The middles, in a column from front to back. */
  COLUMN(false, Alignment::middle);

  private final boolean alongX;
  private final ToDoubleFunction<DoubleSummaryStatistics> line;

  /**
   * @param alongX whether items move along the room's x axis, otherwise along y
   * @param line where it is between the edges of an item along that axis [m]
   */
  Alignment(boolean alongX, ToDoubleFunction<DoubleSummaryStatistics> line) {
    this.alongX = alongX;
    this.line = line;
  }

  private static double middle(DoubleSummaryStatistics edges) {
    return (edges.getMin() + edges.getMax()) / 2;
  }

  /** The end of the keys of its texts. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The plan with all items moved to the line of the last one. */
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
