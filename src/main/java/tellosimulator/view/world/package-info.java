/**
 * The 3D scene in the window, and its cameras.
 *
 * <p>{@link tellosimulator.view.world.Simulator3DScene} is the node in the window. At each UI tick,
 * it builds the scene of the newest snapshot, adds the overlay, and passes both to a {@code
 * SceneView}. The view either shows them in 3D, where {@code SceneNodes} converts instances to
 * JavaFX nodes, or uses the software camera. {@link tellosimulator.view.world.SimulatorCamera}
 * either orbits the selected drone or shows the whole scene; {@code Framing} then fits the scene
 * into the view. The mathematics ({@code Orbit}, {@code ViewWindow}, {@code SmoothFollow}) does not
 * depend on the toolkit. All types are confined to the JavaFX thread. The appearance of the world
 * is the job of {@code scenery}.
 */
package tellosimulator.view.world;
