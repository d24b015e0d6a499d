/**
 * What mission pads look like.
 *
 * <p>{@link tellosimulator.scenery.pad.PadDecals} makes the decals of a room's pads; their textures
 * are drawn in code. The package imports {@code scenery.mesh} and {@code scenery.texture} and is
 * for any thread. What a drone makes of a pad is not its job.
 */
package tellosimulator.scenery.pad;
