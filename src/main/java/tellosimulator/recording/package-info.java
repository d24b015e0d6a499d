/**
 * Recordings of flights: a folder for each, with plain files in the format of docs/recordings.md.
 *
 * <p>{@link tellosimulator.recording.FlightRecorder} listens to a running simulation and taps its
 * wire. On the threads of simulation and network it only puts small immutable records into a
 * bounded queue; a thread of its own, in {@code RecordingWriter}, knows files. Whatever fails there
 * ends a recording, and never a flight.
 *
 * <p>{@link tellosimulator.recording.RecordedFlight} is what a folder says, as far as it can be
 * read; a recording that was cut off is shown until there. Values are immutable and for any thread.
 * The package imports {@code json}, {@code scenario} and {@code video} and what these stand on.
 * What is made of a recording is not its job.
 */
package tellosimulator.recording;
