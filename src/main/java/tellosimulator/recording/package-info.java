/**
 * Recordings of flights: one folder for each flight, with plain files in the format of
 * docs/recordings.md.
 *
 * <p>{@link tellosimulator.recording.FlightRecorder} listens to a running simulation and taps its
 * datagrams. On the simulation and network threads, it only adds small immutable records to a
 * bounded queue; {@code RecordingWriter} writes the files on a separate thread. An error on that
 * thread ends the recording, but never the flight.
 *
 * <p>{@link tellosimulator.recording.RecordedFlight} holds the readable contents of a folder; a
 * recording that was cut off can be read up to its last complete line. Values are immutable. The
 * package imports {@code json}, {@code scenario}, {@code video} and the packages below them. Other
 * packages show, compare and replay recordings.
 */
package tellosimulator.recording;
