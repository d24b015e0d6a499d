/**
 * The room in 3D, with everything that helps to see where drones are, and the cameras that look at
 * it.
 *
 * <p>{@link tellosimulator.view.world.Simulator3DScene} is the part of the window. Its nodes are in
 * the room frame and in metres; {@link tellosimulator.view.FxFrames} turns that into JavaFX's axes
 * once, at the root. {@link tellosimulator.view.world.SimulatorCamera} orbits the selected drone,
 * {@link tellosimulator.view.world.DroneCamera} sits in its nose. Meshes and pictures are made when
 * the room changes, never for a picture. Everything is for the JavaFX thread; the mathematics
 * ({@link tellosimulator.view.world.Orbit} and others) needs no toolkit. The drone itself is the
 * job of {@code view.drone}.
 */
package tellosimulator.view.world;
