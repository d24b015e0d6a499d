/**
 * The lights of the extension board of a RoboMaster TT: what its lamp and its dot matrix show at a
 * moment.
 *
 * <p>A {@link tellosimulator.board.LightOrder} is what a command asks for; {@link
 * tellosimulator.board.BoardLights} is what became of all of them, and follows from simulated time
 * alone. All types are immutable and for any thread. The package imports {@code time}. How a
 * command is written, and what a lamp looks like, are not its job.
 */
package tellosimulator.board;
