/**
 * Tests the drone's text interface against a table of facts.
 *
 * <p>{@link tellosimulator.wire.WireTest} executes each row of the tables in {@code
 * src/test/resources/wire}, where {@code README.md} explains the notation, with a {@link
 * tellosimulator.testing.SteppedDrone}; {@link tellosimulator.wire.FactIndexTest} ensures that
 * every fact has a row. Confined to the test's thread. The details of flight are not its job.
 */
package tellosimulator.wire;
