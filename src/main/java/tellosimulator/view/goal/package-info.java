/**
 * What the drones shall do, in the window.
 *
 * <p>{@link tellosimulator.view.goal.GoalPanel} shows the goals of the opened scenario, which of
 * them are reached, and whether all of them are. It pulls the newest {@code Progress} once a pulse
 * through {@code FxScenario}. Everything is for the JavaFX thread. Judging is the job of {@code
 * goal}.
 */
package tellosimulator.view.goal;
