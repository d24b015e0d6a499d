/**
 * The command line.
 *
 * <p>{@link tellosimulator.Main} reads {@code Options} and chooses how to run; {@link
 * tellosimulator.LogSetup} sets up the log. The package may import everything, and nothing imports
 * it. What an option does is not its job.
 */
package tellosimulator;
