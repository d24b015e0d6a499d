/**
 * Compares two flights with the same commands.
 *
 * <p>{@link tellosimulator.comparison.FlightComparison} pairs the commands of two recordings and
 * measures the drones' motion from their state lines alone, so that flights of real drones can be
 * compared as well. A {@link tellosimulator.comparison.Tolerance} defines which differences are
 * accepted. All types are immutable except {@link tellosimulator.comparison.ComparisonTable}. The
 * package imports {@code recording}. HTML pages are the job of {@code report}.
 */
package tellosimulator.comparison;
