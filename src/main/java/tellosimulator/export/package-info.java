/**
 * Exports recordings to the formats of other tools.
 *
 * <p>{@link tellosimulator.export.ExportFormat} lists the formats. Each format has a class that
 * reads a recording line by line and writes the file. These classes are not thread-safe. The
 * package imports {@code recording}. It does not change or evaluate recordings.
 */
package tellosimulator.export;
