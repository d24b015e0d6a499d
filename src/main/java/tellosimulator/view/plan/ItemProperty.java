package tellosimulator.view.plan;

import java.util.OptionalDouble;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalRegion;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.view.controls.NumberRange;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Shape;

/**
 * A number of an item that people change in the property panel; lengths in centimetres, angles in
 * degrees counter-clockwise, as scenario files have them.
 */
enum ItemProperty {
  X(Range.PLACE) {
    @Override
    OptionalDouble of(FloorPlan plan, PlanItem item) {
      return onFloor(plan, item)
          ? centimeters(plan.placement(item).place().x())
          : OptionalDouble.empty();
    }

    @Override
    FloorPlan with(FloorPlan plan, PlanItem item, double value) {
      Placement now = plan.placement(item);
      return plan.with(item, now.at(new Vec3(Frames.meters(value), now.place().y(), 0)));
    }
  },
  Y(Range.PLACE) {
    @Override
    OptionalDouble of(FloorPlan plan, PlanItem item) {
      return onFloor(plan, item)
          ? centimeters(plan.placement(item).place().y())
          : OptionalDouble.empty();
    }

    @Override
    FloorPlan with(FloorPlan plan, PlanItem item, double value) {
      Placement now = plan.placement(item);
      return plan.with(item, now.at(new Vec3(now.place().x(), Frames.meters(value), 0)));
    }
  },
  /** Height of the drone's feet at a goal. */
  HEIGHT_OF_GOAL(Range.SIZE_OR_NONE) {
    @Override
    OptionalDouble of(Goal goal) {
      return goal instanceof Goal.InRegion at && !(goal instanceof Goal.Land)
          ? centimeters(at.region().place().z())
          : OptionalDouble.empty();
    }

    @Override
    Goal with(Goal goal, double value) {
      Vec3 place = ((Goal.InRegion) goal).region().place();
      return GoalPlacement.moved(goal, place.withZ(Frames.meters(value)));
    }
  },
  RADIUS(Range.SIZE) {
    @Override
    OptionalDouble of(Goal goal) {
      return goal instanceof Goal.InRegion at
          ? centimeters(at.region().radius())
          : OptionalDouble.empty();
    }

    @Override
    Goal with(Goal goal, double value) {
      Goal.InRegion at = (Goal.InRegion) goal;
      return at.at(new GoalRegion(at.region().place(), Frames.meters(value)));
    }
  },
  /** How long a drone shall stay [s]. */
  SECONDS(Range.SECONDS) {
    @Override
    OptionalDouble of(Goal goal) {
      return goal instanceof Goal.Hover hover
          ? OptionalDouble.of(hover.seconds())
          : OptionalDouble.empty();
    }

    @Override
    Goal with(Goal goal, double value) {
      Goal.Hover hover = (Goal.Hover) goal;
      return new Goal.Hover(hover.drone(), hover.region(), value);
    }
  },
  /** Height of an obstacle's foot above the floor. */
  ELEVATION(Range.SIZE_OR_NONE) {
    @Override
    OptionalDouble of(FloorPlan plan, PlanItem item) {
      return item instanceof ObstacleItem body
          ? centimeters(plan.obstacle(body).foot().z())
          : OptionalDouble.empty();
    }

    @Override
    FloorPlan with(FloorPlan plan, PlanItem item, double value) {
      ObstacleItem body = (ObstacleItem) item;
      Obstacle now = plan.obstacle(body);
      return plan.with(body, now.movedTo(now.foot().withZ(Frames.meters(value)), now.heading()));
    }
  },
  /** Of a mission pad at a wall: to the right of the wall's middle. */
  ALONG(Range.PLACE) {
    @Override
    OptionalDouble of(FloorPlan plan, PlanItem item) {
      return item instanceof Pad pad && !onFloor(plan, item)
          ? centimeters(plan.pad(pad).along())
          : OptionalDouble.empty();
    }

    @Override
    FloorPlan with(FloorPlan plan, PlanItem item, double value) {
      MissionPad now = plan.pad((Pad) item);
      return plan.replacing(now.id(), now.movedTo(Frames.meters(value), now.height()));
    }
  },
  /** Of a mission pad at a wall: its middle above the floor. */
  MIDDLE_OF_PAD(Range.SIZE) {
    @Override
    OptionalDouble of(FloorPlan plan, PlanItem item) {
      return item instanceof Pad pad && !onFloor(plan, item)
          ? centimeters(plan.pad(pad).height())
          : OptionalDouble.empty();
    }

    @Override
    FloorPlan with(FloorPlan plan, PlanItem item, double value) {
      MissionPad now = plan.pad((Pad) item);
      return plan.replacing(now.id(), now.movedTo(now.along(), Frames.meters(value)));
    }
  },
  HEADING(Range.ANGLE) {
    @Override
    OptionalDouble of(FloorPlan plan, PlanItem item) {
      return onFloor(plan, item) && !(item instanceof GoalItem)
          ? OptionalDouble.of(rounded(Math.toDegrees(plan.placement(item).heading())))
          : OptionalDouble.empty();
    }

    @Override
    FloorPlan with(FloorPlan plan, PlanItem item, double value) {
      return plan.with(
          item, new Placement(plan.placement(item).place(), Frames.wrapped(Math.toRadians(value))));
    }
  },
  DEPTH(Range.SIZE) {
    @Override
    OptionalDouble of(Shape shape) {
      return shape instanceof Shape.Box box ? centimeters(box.depth()) : OptionalDouble.empty();
    }

    @Override
    Shape with(Shape shape, double meters) {
      Shape.Box box = (Shape.Box) shape;
      return new Shape.Box(meters, box.width(), box.height());
    }
  },
  WIDTH(Range.SIZE) {
    @Override
    OptionalDouble of(Shape shape) {
      if (shape instanceof Shape.Box box) {
        return centimeters(box.width());
      }
      return shape instanceof Shape.Frame frame
          ? centimeters(frame.width())
          : OptionalDouble.empty();
    }

    @Override
    Shape with(Shape shape, double meters) {
      if (shape instanceof Shape.Frame frame) {
        return new Shape.Frame(meters, frame.opening(), frame.beam(), frame.middle());
      }
      Shape.Box box = (Shape.Box) shape;
      return new Shape.Box(box.depth(), meters, box.height());
    }
  },
  /** Of a cylinder, or of a ring's opening. */
  DIAMETER(Range.SIZE) {
    @Override
    OptionalDouble of(Shape shape) {
      if (shape instanceof Shape.Cylinder cylinder) {
        return centimeters(2 * cylinder.radius());
      }
      return shape instanceof Shape.Ring ring
          ? centimeters(2 * ring.radius())
          : OptionalDouble.empty();
    }

    @Override
    Shape with(Shape shape, double meters) {
      if (shape instanceof Shape.Ring ring) {
        double lowest = meters / 2 + ring.tube();
        return new Shape.Ring(meters / 2, ring.tube(), Math.max(lowest, ring.middle()));
      }
      return new Shape.Cylinder(meters / 2, shape.height());
    }
  },
  HEIGHT(Range.SIZE) {
    @Override
    OptionalDouble of(Shape shape) {
      return shape instanceof Shape.Gate ? OptionalDouble.empty() : centimeters(shape.height());
    }

    @Override
    Shape with(Shape shape, double meters) {
      if (shape instanceof Shape.Cylinder cylinder) {
        return new Shape.Cylinder(cylinder.radius(), meters);
      }
      Shape.Box box = (Shape.Box) shape;
      return new Shape.Box(box.depth(), box.width(), meters);
    }
  },
  /** Height of a frame's opening. */
  OPENING(Range.SIZE) {
    @Override
    OptionalDouble of(Shape shape) {
      return shape instanceof Shape.Frame frame
          ? centimeters(frame.opening())
          : OptionalDouble.empty();
    }

    @Override
    Shape with(Shape shape, double meters) {
      Shape.Frame frame = (Shape.Frame) shape;
      double middle = Math.max(meters / 2, frame.middle());
      return new Shape.Frame(frame.width(), meters, frame.beam(), middle);
    }
  },
  /** Height of the middle of a gate's opening above the foot. */
  MIDDLE(Range.SIZE) {
    @Override
    OptionalDouble of(Shape shape) {
      return shape instanceof Shape.Gate gate ? centimeters(gate.middle()) : OptionalDouble.empty();
    }

    @Override
    Shape with(Shape shape, double meters) {
      if (shape instanceof Shape.Ring ring) {
        double middle = Math.max(ring.radius() + ring.tube(), meters);
        return new Shape.Ring(ring.radius(), ring.tube(), middle);
      }
      Shape.Frame frame = (Shape.Frame) shape;
      double middle = Math.max(frame.opening() / 2, meters);
      return new Shape.Frame(frame.width(), frame.opening(), frame.beam(), middle);
    }
  };

  private static final double PRECISION = 10;

  /** Which numbers a field takes; what fits into the room is another question. */
  private static final class Range {
    private static final double LONGEST = Frames.centimeters(Shape.LONGEST);
    private static final NumberRange PLACE = new NumberRange(-LONGEST / 2, LONGEST / 2, 5);
    private static final NumberRange SIZE = new NumberRange(1, LONGEST, 5);
    private static final NumberRange SIZE_OR_NONE = new NumberRange(0, LONGEST, 5);
    private static final NumberRange SECONDS =
        new NumberRange(Goal.SHORTEST_HOVER, Goal.LONGEST_HOVER, 1);
    private static final NumberRange ANGLE = new NumberRange(-360, 360, 15);
  }

  private final NumberRange range;

  ItemProperty(NumberRange range) {
    this.range = range;
  }

  NumberRange range() {
    return range;
  }

  /** The number of an item; empty if it has none. */
  OptionalDouble of(FloorPlan plan, PlanItem item) {
    if (item instanceof GoalItem goal) {
      return of(plan.goal(goal));
    }
    return item instanceof ObstacleItem body
        ? of(plan.obstacle(body).shape())
        : OptionalDouble.empty();
  }

  /** The plan with another number; gates are raised as far as they must. */
  FloorPlan with(FloorPlan plan, PlanItem item, double value) {
    if (item instanceof GoalItem goal) {
      return plan.with(goal, with(plan.goal(goal), value));
    }
    ObstacleItem body = (ObstacleItem) item;
    Obstacle now = plan.obstacle(body);
    Shape shape = with(now.shape(), Frames.meters(value));
    return plan.with(
        body, new Obstacle(now.name(), shape, now.foot(), now.heading(), now.appearance()));
  }

  /** The number of a shape; empty if it has none. */
  OptionalDouble of(Shape shape) {
    return OptionalDouble.empty();
  }

  /** A shape that has the number, with another one [m]. */
  Shape with(Shape shape, double meters) {
    return shape;
  }

  /** The number of a goal; empty if it has none. */
  OptionalDouble of(Goal goal) {
    return OptionalDouble.empty();
  }

  /** A goal that has the number, with another one. */
  Goal with(Goal goal, double value) {
    return goal;
  }

  /** Whether it has a place of its own there. */
  private static boolean onFloor(FloorPlan plan, PlanItem item) {
    if (item instanceof GoalItem goal) {
      return plan.goal(goal) instanceof Goal.InRegion;
    }
    return !(item instanceof Pad pad) || !plan.pad(pad).surface().wall();
  }

  private static OptionalDouble centimeters(double meters) {
    return OptionalDouble.of(rounded(Frames.centimeters(meters)));
  }

  /** To the millimetre or a tenth of a degree, without a negative zero. */
  private static double rounded(double value) {
    return Math.round(value * PRECISION) / PRECISION;
  }
}
