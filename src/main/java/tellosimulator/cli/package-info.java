/**
 * The command line.
 *
 * <p>{@link tellosimulator.cli.Options} declares the simulator's options and turns them into a
 * consistent scenario. A {@link tellosimulator.cli.Subcommand}, found by its {@link
 * tellosimulator.cli.SubcommandName}, has its own options and its own action. {@code OptionTypes}
 * parses the values of options, and reports each error in one sentence. The options are confined to
 * the main thread. The package imports {@code scenario} and the packages that subcommands use; only
 * {@code Main} imports it. Running the simulator is not its job.
 */
package tellosimulator.cli;
