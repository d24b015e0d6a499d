package tellosimulator.view.plan;

import tellosimulator.math.Frames;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Shape;

/** What an item of the plan is and where, in words; lengths in centimetres. */
final class PlanItemText {

  private final Language language;
  private final Messages messages;

  PlanItemText(Language language, Messages messages) {
    this.language = language;
    this.messages = messages;
  }

  /** In the present language. */
  String of(FloorPlan plan, PlanItem item) {
    Placement placement = plan.placement(item);
    if (item instanceof Pad pad && plan.pad(pad).surface().wall()) {
      return messages.now(
          "piece-hanging",
          pad.id(),
          language.say(plan.pad(pad).surface().phrase()),
          cm(plan.pad(pad).along()),
          cm(plan.pad(pad).height()));
    }
    if (item instanceof GoalItem goal) {
      return messages.now("piece-goal", goal.index() + 1, language.say(plan.goal(goal).phrase()));
    }
    return messages.now(
        "piece",
        name(plan, item),
        cm(placement.place().x()),
        cm(placement.place().y()),
        Math.round(Math.toDegrees(placement.heading())));
  }

  private String name(FloorPlan plan, PlanItem item) {
    if (item instanceof Pad pad) {
      return messages.now("piece-pad", pad.id());
    } else if (item instanceof ObstacleItem body) {
      String name = language.say(plan.obstacle(body).label());
      return messages.now("piece-thing", name, size(plan.obstacle(body).shape()));
    }
    return messages.now("piece-start", ((PlanItem.Start) item).drone());
  }

  private String size(Shape shape) {
    if (shape instanceof Shape.Box box) {
      return messages.now("size-box", cm(box.depth()), cm(box.width()), cm(box.height()));
    } else if (shape instanceof Shape.Cylinder cylinder) {
      return messages.now("size-cylinder", cm(2 * cylinder.radius()), cm(cylinder.height()));
    } else if (shape instanceof Shape.Ring ring) {
      return messages.now("size-ring", cm(2 * ring.radius()), cm(ring.middle()));
    }
    Shape.Frame frame = (Shape.Frame) shape;
    return messages.now("size-frame", cm(frame.width()), cm(frame.opening()), cm(frame.middle()));
  }

  private static long cm(double meters) {
    return Math.round(Frames.centimeters(meters));
  }
}
