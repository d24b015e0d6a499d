/**
 * The window's log, which describes events in plain words.
 *
 * <p>{@link tellosimulator.view.log.LogQueue} receives events on the simulation thread. Once per
 * pulse, {@link tellosimulator.view.log.LogPane} moves them into its {@code LogModel}. The model
 * combines the lines about a command into one row, keeps the newest 100,000 rows, and determines
 * which of them pass the filter. Everything except the queue is confined to the JavaFX thread. The
 * words of a line come from the event's phrase, and its level comes from {@link
 * tellosimulator.sim.SimEvent#severity}. The log of a program without a window is not in this
 * package.
 */
package tellosimulator.view.log;
