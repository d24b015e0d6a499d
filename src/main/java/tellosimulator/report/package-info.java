/**
 * Creates reports of flights, each as one HTML file, and the pages about the grades of a class.
 *
 * <p>{@link tellosimulator.report.FlightReport} creates a report of a {@link
 * tellosimulator.recording.RecordedFlight}: {@code ReportData} collects the page's data, {@code
 * FilmStrip} draws the pictures with the software camera, and {@code HtmlTemplate} inserts both
 * into the page. {@link tellosimulator.report.ClassReport} creates the pages about the grades of a
 * class, and {@link tellosimulator.report.GradeFormat} files for other systems. The page's markup,
 * style and scripts are resources in this package. Reports are thread-safe. The package imports
 * {@code grade}, {@code recording}, {@code video} and the packages below them. It does not read the
 * files of recordings.
 */
package tellosimulator.report;
