/**
 * What differs between two flights with the same commands.
 *
 * <p>{@link tellosimulator.comparison.FlightComparison} pairs the commands of two recordings and
 * measures how the drones moved by their state lines alone, so that flights of real drones can be
 * compared, too; a {@link tellosimulator.comparison.Tolerance} says what counts as alike. All is
 * immutable but the printed {@link tellosimulator.comparison.ComparisonTable}. The package imports
 * {@code recording}. Pages for browsers are not its job, but that of {@code report}.
 */
package tellosimulator.comparison;
