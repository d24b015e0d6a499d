/**
 * The state and the constants of a drone.
 *
 * <p>{@link tellosimulator.model.DroneModel} is the single source of truth about a drone. It is
 * written only on the simulation thread. {@link tellosimulator.model.DroneState} is the immutable
 * copy that all other code reads. {@link tellosimulator.model.DroneSpec} contains the airframe's
 * constants with their sources. The package imports {@code world}, {@code extension}, {@code time}
 * and {@code math}. The dynamics of a drone are in {@code physics}.
 */
package tellosimulator.model;
