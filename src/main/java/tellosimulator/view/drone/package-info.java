/**
 * A drone in the window.
 *
 * <p>{@link tellosimulator.view.drone.DroneView} is a drone of the simulation in the 3D scene; its
 * parts come from {@code scenery.drone}, and a pulse only turns and moves them. {@link
 * tellosimulator.view.drone.DroneColors} tells drones apart, here and in all panels. Everything is
 * for the JavaFX thread. Room, cameras and shadows are the job of {@code view.world}.
 */
package tellosimulator.view.drone;
