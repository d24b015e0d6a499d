/**
 * The program without a window.
 *
 * <p>{@link tellosimulator.headless.HeadlessSimulator} combines sockets, simulation and clock. It
 * also writes events to the log. {@code Console} executes typed commands. The control channel of
 * {@code control} is opened on request. The package imports {@code network} and the packages below
 * it. Command-line options are not its job.
 */
package tellosimulator.headless;
