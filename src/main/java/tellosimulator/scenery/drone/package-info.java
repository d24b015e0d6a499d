/**
 * The appearance of a drone.
 *
 * <p>{@link tellosimulator.scenery.drone.DroneParts} contains the parts of one drone. Their shapes
 * are calculated once, in metres and in the body frame (x along the nose, y to the left, z up).
 * {@link tellosimulator.scenery.drone.Livery} distinguishes drones by colour. {@link
 * tellosimulator.scenery.drone.PropellerSpin} and {@link tellosimulator.scenery.drone.StatusLight}
 * determine the rotation of the propellers and the state of the lamp. Shapes and colours are
 * thread-safe. This package does not determine where a drone is.
 */
package tellosimulator.scenery.drone;
