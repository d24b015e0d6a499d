/**
 * The appearance of obstacles.
 *
 * <p>{@link tellosimulator.scenery.furniture.Furniture} creates the parts of obstacles and their
 * instances; the meshes have the sizes that the simulation uses. Equal obstacles share their parts,
 * and equal paints share a texture. {@link tellosimulator.scenery.furniture.FloorShadows} creates
 * the shadows of obstacles on the floor. The package imports {@code scenery.mesh} and {@code
 * scenery.texture}. It does not detect collisions. Thread-safe.
 */
package tellosimulator.scenery.furniture;
