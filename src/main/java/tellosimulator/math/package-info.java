/**
 * Vectors, orientations and the conversions between axes.
 *
 * <p>{@link tellosimulator.math.Vec3} and {@link tellosimulator.math.Attitude} are immutable values
 * for any thread. {@link tellosimulator.math.Frames} is the only place where axes of the core, of
 * the wire and later of pads and of the window are converted. The package imports nothing of the
 * project; physics is not its job. Transcendental functions come from {@code StrictMath}, because
 * results reach traces that must be equal on every machine.
 */
package tellosimulator.math;
