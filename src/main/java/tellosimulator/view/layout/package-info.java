/**
 * The frame of the window and what lies over it.
 *
 * <p>{@link tellosimulator.view.layout.SimulatorPane} gives each part its place. Everything is for
 * the JavaFX thread. What the parts show is not its job.
 */
package tellosimulator.view.layout;
