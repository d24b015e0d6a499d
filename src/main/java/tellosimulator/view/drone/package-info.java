/**
 * A drone as one sees it.
 *
 * <p>{@link tellosimulator.view.drone.DroneView} is a drone of the simulation in the 3D scene, in
 * metres and in the axes of its body (x along the nose, y to the left, z up). Its shapes are
 * calculated once ({@link tellosimulator.view.drone.BodyMesh}, {@link
 * tellosimulator.view.drone.PropellerMesh}); a pulse only turns and moves them. {@link
 * tellosimulator.view.drone.DroneColors} tells drones apart, here and in all panels. Everything is
 * for the JavaFX thread, but shapes and the mathematics of propellers need no toolkit. Room,
 * cameras and shadows are the job of {@code view.world}.
 */
package tellosimulator.view.drone;
