package tellosimulator.view.plan;

import tellosimulator.math.Frames;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;

/** Describes an item of the plan and its position in words. Lengths are in centimetres. */
final class PlanItemText {

  private final Language language;
  private final Messages messages;

  PlanItemText(Language language, Messages messages) {
    this.language = language;
    this.messages = messages;
  }

  /** Returns the description in the current language. */
  String of(FloorPlan plan, PlanItem item) {
    return item.match(
        start -> placed(plan, start, messages.now("piece-start", start.drone())),
        pad ->
            plan.pad(pad).surface().wall()
                ? hanging(plan.pad(pad))
                : placed(plan, pad, messages.now("piece-pad", pad.id())),
        obstacle -> placed(plan, obstacle, description(plan.obstacle(obstacle))),
        goal ->
            messages.now("piece-goal", goal.index() + 1, language.say(plan.goal(goal).phrase())));
  }

  private String hanging(MissionPad pad) {
    return messages.now(
        "piece-hanging",
        pad.id(),
        language.say(pad.surface().phrase()),
        cm(pad.along()),
        cm(pad.height()));
  }

  private String placed(FloorPlan plan, PlanItem item, String name) {
    Placement placement = plan.placement(item);
    return messages.now(
        "piece",
        name,
        cm(placement.place().x()),
        cm(placement.place().y()),
        Math.round(Math.toDegrees(placement.heading())));
  }

  private String description(Obstacle obstacle) {
    ShapeLengths shape = ShapeLengths.of(obstacle.shape());
    Object[] lengths = shape.lengths().stream().map(length -> cm(length.meters())).toArray();
    return messages.now(
        "piece-thing",
        language.say(obstacle.label()),
        messages.now("size-" + shape.kind(), lengths));
  }

  private static long cm(double meters) {
    return Math.round(Frames.centimeters(meters));
  }
}
