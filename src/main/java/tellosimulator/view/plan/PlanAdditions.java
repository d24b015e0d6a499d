package tellosimulator.view.plan;

import java.util.List;
import java.util.function.Function;
import tellosimulator.goal.Goal;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.view.plan.PlanItem.GoalItem;
import tellosimulator.view.plan.PlanItem.ObstacleItem;
import tellosimulator.view.plan.PlanItem.Pad;
import tellosimulator.view.plan.PlanItem.Start;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.Room;

/** Adds obstacles, mission pads, goals and drones to a plan. For the JavaFX thread. */
final class PlanAdditions {

  private final PlanEditor editor;

  PlanAdditions(PlanEditor editor) {
    this.editor = editor;
  }

  /** Adds another item like the one that was selected last, beside it. */
  void duplicate() {
    PlanItem item = editor.selected().orElse(null);
    if (item instanceof ObstacleItem body) {
      Obstacle like = editor.plan().obstacle(body);
      String name = editor.plan().freeName(like.name().replaceFirst(" [0-9]+$", ""));
      addNear(
          like.foot(),
          new ObstacleItem(editor.plan().arena().obstacles().size()),
          place ->
              editor
                  .plan()
                  .with(like.named(name).movedTo(place.withZ(like.foot().z()), like.heading())));
    } else if (item instanceof Pad pad) {
      addPad(editor.plan().placement(pad).place());
    } else if (item instanceof GoalItem goal) {
      add(editor.plan().goal(goal), editor.plan().placement(goal).place());
    } else if (item instanceof Start start) {
      add(editor.plan().drone(start), editor.plan().placement(start).place());
    }
  }

  /** Adds an obstacle near a place, and selects it. */
  void add(PaletteItem kind, Vec3 near) {
    Room room = editor.plan().arena().room();
    String name = editor.plan().freeName(kind.word());
    int index = editor.plan().arena().obstacles().size();
    addNear(
        near,
        new ObstacleItem(index),
        place ->
            editor.plan().with(new Obstacle(name, kind.shape(room), place, 0, kind.appearance())));
  }

  /** Adds the mission pad of the next free id near a place, if there is one left. */
  void addPad(Vec3 near) {
    editor.plan().freePadIds().stream()
        .findFirst()
        .ifPresent(
            id ->
                addNear(
                    near,
                    new Pad(id),
                    place -> editor.plan().with(MissionPad.onFloor(id, place, 0))));
  }

  /** Adds a goal as the last one, near a place or at what it names, and selects it. */
  void addGoal(GoalKind kind, Vec3 near) {
    kind.goal(editor.plan(), editor.selected()).ifPresent(goal -> add(goal, near));
  }

  private void add(Goal goal, Vec3 near) {
    GoalItem item = new GoalItem(editor.plan().goals().size());
    if (goal instanceof Goal.InRegion at) {
      double height = at.region().place().z();
      addNear(
          near, item, place -> editor.plan().with(GoalPlacement.moved(goal, place.withZ(height))));
    } else {
      editor.carryOut(editor.plan().with(goal), List.of(item));
    }
  }

  /** Adds a drone of the next number near a place, like the last one, and selects it. */
  void addDrone(Vec3 near) {
    add(editor.plan().drones().get(editor.plan().drones().size() - 1), near);
  }

  private void add(PlannedDrone like, Vec3 near) {
    int number = editor.plan().drones().size() + 1;
    if (number > AddressPlan.MOST_DRONES) {
      editor.refuse(PlacementProblem.MOST_DRONES);
      return;
    }
    addNear(
        near,
        new Start(number),
        place ->
            editor
                .plan()
                .with(
                    new PlannedDrone(
                        like.origin().another(), new Pose(place, like.start().attitude()))));
  }

  private void addNear(Vec3 near, PlanItem item, Function<Vec3, FloorPlan> adding) {
    FreePlace.near(near, item, adding)
        .ifPresentOrElse(
            wanted -> editor.carryOut(wanted, List.of(item)),
            () ->
                editor.refuse(
                    PlacementProblem.problem(adding.apply(near), item)
                        .orElse(PlacementProblem.OUTSIDE)));
  }
}
