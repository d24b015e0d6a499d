/**
 * What obstacles look like.
 *
 * <p>{@link tellosimulator.scenery.furniture.Furniture} makes parts of obstacles and puts them into
 * the room; the meshes have the sizes with which the simulation calculates. Parts of like obstacles
 * are the same, and so are the pictures of like covers. The package stands on {@code scenery.room}
 * and {@code scenery.paint}; what stops a drone is not its job.
 */
package tellosimulator.scenery.furniture;
