/**
 * What the room and the drones in it look like: the one description from which the window and the
 * drones' cameras draw, so that a thing is at the same place in both.
 *
 * <p>{@link tellosimulator.scenery.Part} is a mesh with a picture on it, {@link
 * tellosimulator.scenery.Scene} the parts of a moment, each at its place in the room frame. All
 * values are immutable and for any thread. Drawing is not its job; neither JavaFX nor sockets are
 * known here.
 */
package tellosimulator.scenery;
