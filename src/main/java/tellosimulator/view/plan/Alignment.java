package tellosimulator.view.plan;

import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import tellosimulator.math.Vec3;

/** A line to which several items are moved; the plan shows the front wall above. */
enum Alignment {
  /** The front edges, which are the upper ones of the plan. */
  FRONT(true) {
    @Override
    double line(Placement placement, DoubleStream corners) {
      return corners.max().orElseThrow();
    }
  },
  BACK(true) {
    @Override
    double line(Placement placement, DoubleStream corners) {
      return corners.min().orElseThrow();
    }
  },
  LEFT(false) {
    @Override
    double line(Placement placement, DoubleStream corners) {
      return corners.max().orElseThrow();
    }
  },
  RIGHT(false) {
    @Override
    double line(Placement placement, DoubleStream corners) {
      return corners.min().orElseThrow();
    }
  },
  /** The middles, in a row from left to right. */
  ROW(true) {
    @Override
    double line(Placement placement, DoubleStream corners) {
      return placement.place().x();
    }
  },
  /** The middles, in a column from front to back. */
  COLUMN(false) {
    @Override
    double line(Placement placement, DoubleStream corners) {
      return placement.place().y();
    }
  };

  private final boolean alongX;

  /**
   * @param alongX whether items move along the room's x axis, otherwise along y
   */
  Alignment(boolean alongX) {
    this.alongX = alongX;
  }

  /** Where the line of an item is along the axis [m]; its corners' coordinates are given. */
  abstract double line(Placement placement, DoubleStream corners);

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
    Placement placement = plan.placement(item);
    return line(
        placement,
        plan.outline(item).corners(placement).stream()
            .mapToDouble(corner -> alongX ? corner.x() : corner.y()));
  }
}
