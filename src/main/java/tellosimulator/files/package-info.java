/**
 * Common operations on files.
 *
 * <p>{@link tellosimulator.files.IoReason} explains to users why a file could not be read or
 * written; {@link tellosimulator.files.AtomicFile} replaces a whole file; {@link
 * tellosimulator.files.TemporaryFolder} is deleted when it is closed. All classes are thread-safe.
 * The package imports only {@code words}. The content of files is not its job.
 */
package tellosimulator.files;
