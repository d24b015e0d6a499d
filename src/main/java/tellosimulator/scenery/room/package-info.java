/**
 * What the room looks like: {@link tellosimulator.scenery.room.Interior} makes its surfaces, {@link
 * tellosimulator.scenery.room.StartMark} and {@link tellosimulator.scenery.room.BlobShadow} the
 * decals of drones. All in metres and in the room frame, all values immutable and for any thread.
 * Textures are computed or read when they are first used.
 */
package tellosimulator.scenery.room;
