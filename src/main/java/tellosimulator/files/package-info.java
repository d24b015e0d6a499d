/**
 * What the program's files have in common.
 *
 * <p>{@link tellosimulator.files.IoReason} says in words for people why a file could not be read or
 * written; {@link tellosimulator.files.AtomicFile} replaces a whole file; {@link
 * tellosimulator.files.TemporaryFolder} is deleted at the end. Nothing here keeps state; all of it
 * is for any thread. The package imports nothing of the project. What stands in a file is not its
 * job.
 */
package tellosimulator.files;
