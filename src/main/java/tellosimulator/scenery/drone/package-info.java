/**
 * What a drone looks like.
 *
 * <p>{@link tellosimulator.scenery.drone.DroneParts} are the parts of one drone; its shapes are
 * calculated once, in metres and in the axes of its body (x along the nose, y to the left, z up).
 * {@link tellosimulator.scenery.drone.Livery} tells drones apart. {@link
 * tellosimulator.scenery.drone.PropellerSpin} and {@link tellosimulator.scenery.drone.StatusLight}
 * say what turns and what shines. Shapes and colours are for any thread. Where a drone is, is not
 * its job.
 */
package tellosimulator.scenery.drone;
