/**
 * Reports of flights, as one HTML file each.
 *
 * <p>{@link tellosimulator.report.FlightReport} makes one of a {@link
 * tellosimulator.recording.RecordedFlight}: {@code ReportData} says what the page needs, {@code
 * FilmStrip} draws its pictures with the software camera, and {@code HtmlTemplate} puts all of it
 * into the page, whose markup, style and scripts are resources beside the classes. For any thread.
 * The package imports {@code recording} and {@code video} and what these stand on. Reading files of
 * recordings is not its job.
 */
package tellosimulator.report;
