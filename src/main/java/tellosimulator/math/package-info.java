/**
 * Vectors, orientations and the conversions between axes.
 *
 * <p>{@link tellosimulator.math.Vec3} and {@link tellosimulator.math.Attitude} are immutable
 * values. Only {@link tellosimulator.math.Frames} converts between the axes of the core, the wire
 * and the screen. The package imports no other package of the project. Transcendental functions
 * come from {@code StrictMath}, so that the same flight is identical on every machine. Physics is
 * not its job.
 */
package tellosimulator.math;
