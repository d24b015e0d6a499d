/**
 * The flight logic of a drone. It turns orders into targets for the physics.
 *
 * <p>{@link tellosimulator.controller.DroneController} carries out orders, regardless of the
 * protocol through which they arrived, and returns a {@link tellosimulator.controller.Result}.
 * {@code Flight} manages the sequence of maneuvers. {@code Autopilot} flies one {@code Maneuver}
 * and decides when the maneuver is over. To add a maneuver, write a class that implements {@code
 * Maneuver}. Everything is confined to the simulation thread. The package depends on {@code
 * physics} and {@code fault}. Wire texts, sockets and the physics itself belong to other packages.
 */
package tellosimulator.controller;
