/**
 * JSON as the project reads and writes it: the lines of the control channel and the files of a
 * recorded flight.
 *
 * <p>{@link tellosimulator.json.Json} turns text into maps, lists, texts, numbers and truth values,
 * and back. It reads nothing that is nested deeper than a bound. All of it is for any thread. The
 * package imports nothing of the project; what the members mean is not its job.
 */
package tellosimulator.json;
