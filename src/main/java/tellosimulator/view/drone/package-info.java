/**
 * {@link tellosimulator.view.drone.DroneColors} provides the colours that distinguish drones in all
 * panels. The colours are the same as in the scene ({@code scenery.drone}). Everything is
 * thread-safe. The package does not draw anything.
 */
package tellosimulator.view.drone;
