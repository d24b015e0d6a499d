/**
 * The room from above, in which people place things with the mouse.
 *
 * <p>{@link tellosimulator.view.plan.PlanPane} is the view: a plan with a palette and a line that
 * says what is chosen. {@link tellosimulator.view.plan.PlanEditor} holds what is chosen and what
 * can be undone, and sends a control for each change; what is there comes from the simulation's
 * snapshots. {@link tellosimulator.view.plan.FloorPlan} and {@link
 * tellosimulator.view.plan.PlacementProblem} are values and rules without JavaFX. The rest is for
 * the JavaFX thread. What things look like in 3D is not its job.
 */
package tellosimulator.view.plan;
