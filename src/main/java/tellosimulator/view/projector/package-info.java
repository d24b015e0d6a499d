/**
 * What a class sees on the wall.
 *
 * <p>{@link tellosimulator.view.projector.ProjectorPane} lies over the 3D scene and says in large
 * type what matters from afar: goals, clock, drones, and the last command with its outcome. It
 * pulls them from {@code view.model} once a pulse while it is shown. Everything is for the JavaFX
 * thread. Hiding the other parts of the window is the job of {@code view.layout}.
 */
package tellosimulator.view.projector;
