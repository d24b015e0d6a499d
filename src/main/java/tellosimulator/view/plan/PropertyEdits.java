package tellosimulator.view.plan;

import java.util.List;
import java.util.function.UnaryOperator;
import tellosimulator.goal.Challenge;
import tellosimulator.goal.Goal;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;

/** Changes properties of the item of a plan that was selected last. For the JavaFX thread. */
final class PropertyEdits {

  private final PlanEditor editor;

  PropertyEdits(PlanEditor editor) {
    this.editor = editor;
  }

  /** Gives the item that was selected last another number. */
  void change(ItemProperty property, double value) {
    editor
        .selected()
        .filter(item -> property.of(editor.plan(), item).isPresent())
        .ifPresent(item -> editor.tryOut(property.with(editor.plan(), item, value)));
  }

  /** Gives the selected obstacle another name, if no other has it. */
  void rename(String name) {
    if (editor.selected().orElse(null) instanceof ObstacleItem body) {
      FloorPlan wanted = editor.plan().with(body, editor.plan().obstacle(body).named(name));
      boolean taken =
          editor.plan().arena().obstacles().stream()
              .anyMatch(
                  other ->
                      other.name().equals(name) && !other.equals(editor.plan().obstacle(body)));
      if (taken) {
        editor.refuse(PlacementProblem.NAME_TAKEN);
      } else {
        carryOut(wanted, editor.selection());
      }
    }
  }

  /** Gives the selected obstacle or drone another colour, as one writes #rrggbb. */
  void paint(int rgb) {
    PlanItem item = editor.selected().orElse(null);
    if (item instanceof ObstacleItem body) {
      Obstacle now = editor.plan().obstacle(body);
      ObstacleAppearance appearance =
          new ObstacleAppearance(rgb, now.appearance().pattern(), now.appearance().pictures());
      editor.carryOut(
          editor
              .plan()
              .with(
                  body,
                  new Obstacle(now.name(), now.shape(), now.foot(), now.heading(), appearance)));
    } else if (item instanceof Start start) {
      PlannedDrone now = editor.plan().drone(start);
      editor.carryOut(
          editor.plan().with(start, new PlannedDrone(now.origin().painted(rgb), now.start())));
    }
  }

  /** Gives the selected goal other words: another gate, another drone, another way. */
  void change(UnaryOperator<Goal> change) {
    if (editor.selected().orElse(null) instanceof GoalItem goal) {
      editor.carryOut(editor.plan().with(goal, change.apply(editor.plan().goal(goal))));
    }
  }

  /** Changes what holds for all goals. */
  void changeRules(UnaryOperator<Challenge> change) {
    editor.carryOut(editor.plan().withChallenge(change.apply(editor.plan().challenge())));
  }

  /** Gives the selected pad, goal or drone another number; those between make room for it. */
  void renumber(int number) {
    PlanItem item = editor.selected().orElse(null);
    if (item instanceof Pad pad && pad.id() != number) {
      MissionPad now = editor.plan().pad(pad);
      MissionPad renumbered =
          new MissionPad(number, now.surface(), now.along(), now.height(), now.rotation());
      FloorPlan wanted = editor.plan().replacing(pad.id(), renumbered);
      carryOut(wanted, List.of(new Pad(number)));
    } else if (item instanceof GoalItem goal && number <= editor.plan().goals().size()) {
      editor.carryOut(editor.plan().renumbered(goal, number), List.of(new GoalItem(number - 1)));
    } else if (item instanceof Start start && number <= editor.plan().drones().size()) {
      if (editor.faultNamesDrone()) {
        editor.refuse(PlacementProblem.NAMED_BY_FAULT);
      } else {
        editor.carryOut(editor.plan().renumbered(start, number), List.of(new Start(number)));
      }
    }
  }

  /** Unless a goal could not be reached any more. */
  private void carryOut(FloorPlan wanted, List<PlanItem> items) {
    PlacementProblem.problemWithGoals(editor.plan(), wanted)
        .ifPresentOrElse(editor::refuse, () -> editor.carryOut(wanted, items));
  }
}
