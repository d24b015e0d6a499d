/**
 * What the room and the drones in it look like: the one description from which the window and the
 * drones' cameras draw.
 *
 * <p>{@link tellosimulator.scenery.SceneBuilder} builds the {@link tellosimulator.scenery.Scene} of
 * a snapshot: instances of parts, each at its pose in the room frame. The packages below it make
 * the parts, of the values in {@code scenery.mesh}. All values are immutable and for any thread.
 * Drawing is not its job; neither JavaFX nor sockets are known here.
 */
package tellosimulator.scenery;
