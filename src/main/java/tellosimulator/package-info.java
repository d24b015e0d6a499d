/**
 * The entry point.
 *
 * <p>{@link tellosimulator.Main} reads the options of {@code cli}, sets up the log, and runs the
 * simulator with or without a window, or a subcommand. The package may import everything, and
 * nothing imports it.
 */
package tellosimulator;
