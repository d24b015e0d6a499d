/**
 * What a scenario asks of the drones, and whether they do it.
 *
 * <p>A {@link tellosimulator.goal.Challenge} is a list of {@link tellosimulator.goal.Goal}s with
 * its rules; {@link tellosimulator.goal.GoalWatch} watches a simulation and keeps the {@link
 * tellosimulator.goal.Progress}, which is immutable and for any thread. Only the simulation thread
 * judges. The package imports {@code sim} and what that stands on. Files, exit codes and windows
 * are not its job.
 */
package tellosimulator.goal;
