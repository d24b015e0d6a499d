/**
 * {@link tellosimulator.view.drone.DroneColors} tells drones apart in all panels, by the colours
 * that they have in the scene ({@code scenery.drone}). For any thread; drawing is not its job.
 */
package tellosimulator.view.drone;
