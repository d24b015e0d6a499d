/**
 * JSON for the lines of the control channel and the files of recorded flights.
 *
 * <p>{@link tellosimulator.json.Json} parses a text into maps, lists, strings, numbers and
 * booleans, and formats these as text. It rejects text that is nested too deeply. {@link
 * tellosimulator.json.JsonRecords} converts records to such values and back. All classes are
 * thread-safe. The package imports no other package of the project. The meaning of the members is
 * not its job.
 */
package tellosimulator.json;
