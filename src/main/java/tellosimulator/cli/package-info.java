/**
 * The command line's options.
 *
 * <p>{@link tellosimulator.cli.Options} declares them all and turns them into a {@link
 * tellosimulator.cli.Launch}, which is known to fit together; {@code OptionTypes} reads their
 * values, and each mistake is one sentence. For the main thread. The package imports {@code
 * scenario} and {@code video} and what these stand on; only {@code Main} imports it. What an option
 * does is not its job.
 */
package tellosimulator.cli;
