/**
 * How a drone moves.
 *
 * <p>{@link tellosimulator.physics.QuadcopterDynamics} turns a motion and a {@link
 * tellosimulator.physics.Setpoint} into the motion a step later: outer loops for position and
 * velocity, an inner loop for the attitude, and the integrator. It runs on the simulation thread.
 * The package imports {@code model}, {@code time} and {@code math}. What a drone shall do is not
 * its job, nor what stands in its way.
 */
package tellosimulator.physics;
