/**
 * The goals of a scenario, and their evaluation.
 *
 * <p>A {@link tellosimulator.goal.Challenge} is a list of {@link tellosimulator.goal.Goal}s with
 * its rules. {@link tellosimulator.goal.GoalWatch} watches a simulation and publishes an immutable
 * {@link tellosimulator.goal.Progress} with its {@link tellosimulator.goal.Score}. Goals are
 * evaluated on the simulation thread only. The package imports {@code sim} and its dependencies.
 * Files, exit codes and windows belong to other packages.
 */
package tellosimulator.goal;
