/**
 * The dynamics of a drone.
 *
 * <p>{@link tellosimulator.physics.QuadcopterDynamics} computes the motion after a step from the
 * current motion and a {@link tellosimulator.physics.Setpoint}. The computation consists of outer
 * loops for position and velocity, an inner loop for the attitude, and an integrator. It runs on
 * the simulation thread. The package imports {@code model}, {@code time} and {@code math}. Other
 * packages contain the flight logic and the collisions.
 */
package tellosimulator.physics;
