/**
 * The appearance of mission pads.
 *
 * <p>{@link tellosimulator.scenery.pad.PadDecals} creates the decals of a room's pads. Their
 * textures are drawn in code. The package imports {@code scenery.mesh} and {@code scenery.texture}.
 * It does not detect pads. Thread-safe.
 */
package tellosimulator.scenery.pad;
