/**
 * Recordings in the formats of other tools.
 *
 * <p>{@link tellosimulator.export.ExportFormat} is the table of them; each has a class that reads a
 * recording line by line, and one that writes its files. For one thread. The package imports {@code
 * recording}. To change or to judge what was recorded is not its job.
 */
package tellosimulator.export;
