/**
 * The entry point.
 *
 * <p>{@link tellosimulator.Main} reads the options of {@code cli}, sets up the log and chooses how
 * to run: in a window or without. The package may import everything, and nothing imports it.
 */
package tellosimulator;
