/**
 * The appearance of the room. {@link tellosimulator.scenery.room.Interior} creates its surfaces.
 * {@link tellosimulator.scenery.room.StartDecal} and {@link tellosimulator.scenery.room.BlobShadow}
 * create the decals of drones. All lengths are in metres, all positions are in the room frame, and
 * all values are immutable. Textures are computed or read on first use.
 */
package tellosimulator.scenery.room;
