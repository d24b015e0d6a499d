/**
 * The scene in the window, and the cameras that look at it.
 *
 * <p>{@link tellosimulator.view.world.Simulator3DScene} is the part of the window. Once a beat it
 * has the scene of the newest snapshot built, adds the overlay, and hands both to a {@code
 * SceneView}: in 3D, where {@code SceneNodes} turns instances into JavaFX nodes, or rendered by the
 * software camera. {@link tellosimulator.view.world.SimulatorCamera} shows the whole scene, which
 * {@code Framing} fits into the picture, or orbits the selected drone; the mathematics ({@code
 * Orbit}, {@code ViewWindow}, {@code SmoothFollow}) needs no toolkit. Everything is for the JavaFX
 * thread. What the world looks like is the job of {@code scenery}.
 */
package tellosimulator.view.world;
