/**
 * The command line.
 *
 * <p>{@link tellosimulator.cli.Options} declares the simulator's options and turns them into a
 * {@link tellosimulator.cli.Launch}, which is known to fit together; a {@link
 * tellosimulator.cli.Subcommand}, found by its {@link tellosimulator.cli.SubcommandName}, has
 * options of its own and does what it is for. {@code OptionTypes} reads their values, and each
 * mistake is one sentence. For the main thread. The package imports {@code scenario} and what
 * subcommands do; only {@code Main} imports it. To run the simulator is not its job.
 */
package tellosimulator.cli;
