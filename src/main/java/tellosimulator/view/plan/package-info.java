/**
 * The floor plan of the room, an editor for placing items with the mouse.
 *
 * <p>{@link tellosimulator.view.plan.PlanPane} is the view: a plan with a palette and a status
 * line. {@link tellosimulator.view.plan.PlanEditor} holds the selection and the undo history, and
 * sends each change to the simulation. The placed items come from the simulation's snapshots.
 * {@link tellosimulator.view.plan.FloorPlan} and {@link tellosimulator.view.plan.PlacementProblem}
 * are values and rules without JavaFX. All other types are confined to the JavaFX thread. The
 * package does not determine the appearance of items in 3D.
 */
package tellosimulator.view.plan;
