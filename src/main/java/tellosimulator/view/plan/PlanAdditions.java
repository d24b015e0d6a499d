package tellosimulator.view.plan;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;

/** Adds obstacles, mission pads, goals and drones to a plan. Confined to the JavaFX thread. */
final class PlanAdditions {

  private final PlanEditor editor;

  PlanAdditions(PlanEditor editor) {
    this.editor = editor;
  }

  /** Copies the item that was selected last, and adds the copy near the original. */
  void duplicate() {
    editor
        .selected()
        .ifPresent(
            item ->
                copied(editor.plan(), item)
                    .ifPresent(copy -> add(copy, editor.plan().placement(item).place())));
  }

  private static Optional<PlanChange> copied(FloorPlan plan, PlanItem item) {
    return item.match(
        start -> Optional.of(PlanChange.adding(plan.drone(start), plan)),
        pad -> PaletteItem.PAD.adding(plan, Optional.empty()),
        obstacle -> {
          String kind = plan.obstacle(obstacle).name().replaceFirst(" [0-9]+$", "");
          return Optional.of(
              PlanChange.adding(plan.obstacle(obstacle).named(plan.freeName(kind)), plan));
        },
        goal -> Optional.of(PlanChange.adding(plan.goal(goal), plan)));
  }

  /**
   * Adds an item near a place, and selects it. A goal that names a gate or pad is placed at that
   * gate or pad instead.
   */
  void add(PaletteItem kind, Vec3 near) {
    kind.adding(editor.plan(), editor.selected()).ifPresent(added -> add(added, near));
  }

  private void add(PlanChange added, Vec3 near) {
    if (added.plan().drones().size() > AddressPlan.MOST_DRONES) {
      editor.refuse(PlacementProblem.MOST_DRONES);
      return;
    }
    Optional<FloorPlan> placed =
        added.plan().namesAnother(added.item())
            ? Optional.of(added.plan())
            : FreePlace.near(near, added);
    placed.ifPresentOrElse(
        wanted -> editor.carryOut(wanted, List.of(added.item())),
        () ->
            editor.refuse(
                PlacementProblem.problem(added.at(near), added.item())
                    .orElse(PlacementProblem.OUTSIDE)));
  }
}
