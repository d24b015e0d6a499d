/**
 * What mission pads look like.
 *
 * <p>{@link tellosimulator.scenery.pad.PadCards} puts them into the room; their design is drawn in
 * code. The package stands on {@code scenery.room} and {@code scenery.paint} and is for any thread.
 * What a drone makes of a pad is not its job.
 */
package tellosimulator.scenery.pad;
