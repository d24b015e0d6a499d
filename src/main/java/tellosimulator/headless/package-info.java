/**
 * The program without a window.
 *
 * <p>{@link tellosimulator.headless.HeadlessSimulator} puts sockets, simulation and clock together;
 * {@code Console} takes what is typed; {@link tellosimulator.headless.EventLog} writes what happens
 * to the log; {@code control} is open if somebody asks for it. The package imports {@code network}
 * and what that stands on. Options of the command line are not its job.
 */
package tellosimulator.headless;
