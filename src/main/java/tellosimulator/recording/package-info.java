/**
 * Recordings of flights, in folders of plain files.
 *
 * <p>{@link tellosimulator.recording.RecordedFlight} is what a folder says, as far as it can be
 * read; a recording that was cut off is shown until there. Values are immutable and for any thread.
 * The package imports {@code json} and {@code scenario} and what these stand on. What is made of a
 * recording is not its job.
 */
package tellosimulator.recording;
