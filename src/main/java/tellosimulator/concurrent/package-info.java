/**
 * Threads that never end silently.
 *
 * <p>A {@link tellosimulator.concurrent.Worker} gives an {@link tellosimulator.concurrent.Agent} a
 * thread and repeats its work; it is the only class that starts threads. Every exception and error
 * is logged in one sentence, and the agent's {@link tellosimulator.concurrent.ErrorPolicy} decides
 * whether the worker continues. A worker that cannot continue passes its failure to the thread's
 * handler for uncaught exceptions, which ends the program. The package imports no other package of
 * the project. Timing is not its job; agents wait with a clock of the package {@code time}.
 */
package tellosimulator.concurrent;
