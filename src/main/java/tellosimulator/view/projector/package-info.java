/**
 * The classroom display, meant to be shown on a projector.
 *
 * <p>{@link tellosimulator.view.projector.ProjectorPane} lies over the 3D scene and shows the
 * essentials in large type: goals, clock, drones, and the last command with its outcome. It reads
 * them from {@code view.model} once per UI tick while it is visible. All types are confined to the
 * JavaFX thread. Hiding the other parts of the window is the job of {@code view.layout}.
 */
package tellosimulator.view.projector;
