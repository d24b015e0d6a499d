/**
 * What obstacles look like.
 *
 * <p>{@link tellosimulator.scenery.furniture.Furniture} makes the parts of obstacles and their
 * instances; meshes have the sizes with which the simulation computes. Like obstacles share their
 * parts, and like paint its texture. {@link tellosimulator.scenery.furniture.ContactShadows} are
 * the shadows of all of them on the floor around them, {@link
 * tellosimulator.scenery.furniture.CastShadows} those in the key light. The package imports {@code
 * scenery.mesh} and {@code scenery.texture}; what stops a drone is not its job. For any thread.
 */
package tellosimulator.scenery.furniture;
