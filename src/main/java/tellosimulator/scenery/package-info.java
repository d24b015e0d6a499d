/**
 * The appearance of the room and the drones in it. Both the window and the drones' cameras render
 * from this one description.
 *
 * <p>{@link tellosimulator.scenery.SceneBuilder} builds the {@link tellosimulator.scenery.Scene} of
 * a snapshot: instances of parts, each at its pose in the room frame. The subpackages create the
 * parts from the value types in {@code scenery.mesh}. All values are immutable. This package does
 * not render, and it depends on neither JavaFX nor sockets.
 */
package tellosimulator.scenery;
