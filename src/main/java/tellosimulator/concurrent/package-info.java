/**
 * Threads that do not end in silence.
 *
 * <p>A {@link tellosimulator.concurrent.Worker} gives an {@link tellosimulator.concurrent.Agent} a
 * thread and repeats its work; it is the only place that starts threads. What the work throws,
 * errors included, is said in one sentence; the agent's {@link
 * tellosimulator.concurrent.ErrorPolicy} decides whether it goes on. A worker that cannot go on
 * hands its failure to the thread's handler for uncaught exceptions, with which the program ends.
 * The package imports nothing of the project. Pace is not its job: an agent waits by a clock of
 * {@code time}.
 */
package tellosimulator.concurrent;
