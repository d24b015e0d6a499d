/**
 * The panel for the scenario's goals.
 *
 * <p>{@link tellosimulator.view.goal.GoalPanel} shows the goals of the opened scenario, their
 * progress, and the outcome. It reads the latest {@code Progress} once per pulse through {@code
 * FxScenario}. Everything is confined to the JavaFX thread. The goals are evaluated in the package
 * {@code goal}, not here.
 */
package tellosimulator.view.goal;
