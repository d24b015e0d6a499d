/**
 * The log of the window: what happened, in plain words.
 *
 * <p>{@link tellosimulator.view.log.LogQueue} takes events on the simulation's thread; once a pulse
 * {@link tellosimulator.view.log.LogPane} moves them into its {@code LogModel}, which makes one row
 * of the lines about a command, and keeps the newest 100,000 rows and those of them that pass the
 * filter. All but the queue is for the JavaFX thread. The words themselves are made where things
 * happen, and how much a line matters is said by {@link tellosimulator.sim.SimEvent#severity}. The
 * log of the program without a window is not its job.
 */
package tellosimulator.view.log;
