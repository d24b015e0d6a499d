/**
 * The drone's text interface against a table of facts.
 *
 * <p>{@link tellosimulator.wire.WireTest} carries out each row of the tables under {@code
 * src/test/resources/wire}, where {@code README.md} explains the notation, with a {@link
 * tellosimulator.testing.SteppedDrone}; {@link tellosimulator.wire.FactIndexTest} sees to it that
 * no fact is without a row. For the thread of the test. How the drone flies in detail is not its
 * job.
 */
package tellosimulator.wire;
