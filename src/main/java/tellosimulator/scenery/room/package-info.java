/**
 * What the room looks like: {@link tellosimulator.scenery.room.Interior} makes its parts, {@link
 * tellosimulator.scenery.room.GroundMark} what drones leave on its floor. All in metres and in the
 * room frame, all values immutable and for any thread. Pictures are drawn when they are first
 * needed.
 */
package tellosimulator.scenery.room;
