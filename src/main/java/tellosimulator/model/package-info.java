/**
 * What a drone is and how it is at a moment.
 *
 * <p>{@link tellosimulator.model.DroneModel} is the single source of truth of a drone, written only
 * within a step on the simulation thread; {@link tellosimulator.model.DroneState} is the immutable
 * copy that all others read. {@link tellosimulator.model.DroneSpec} holds the airframe's constants
 * with their sources. The package imports {@code world}, {@code profile}, {@code time} and {@code
 * math}. How a drone comes to move is not its job.
 */
package tellosimulator.model;
