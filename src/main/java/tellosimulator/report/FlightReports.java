package tellosimulator.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import tellosimulator.files.IoReason;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;

/**
 * Writes a report of each flight in a run after the run has ended. If there is no recording folder,
 * flights are recorded in a temporary folder that is deleted afterwards. Thread-safe.
 */
public final class FlightReports {

  private final Path file;
  private final RecordingFolder recordings;
  private final Optional<TemporaryFolder> temporary;
  private boolean written;

  private FlightReports(
      Path file, RecordingFolder recordings, Optional<TemporaryFolder> temporary) {
    this.file = file;
    this.recordings = recordings;
    this.temporary = temporary;
  }

  /**
   * Prepares the reports for a run that has not begun yet.
   *
   * @param file the report of the first flight; the files of later flights get a number
   * @param folder the folder for recordings; empty if they are not kept
   * @throws IOException if the temporary folder cannot be created
   */
  public static FlightReports to(Path file, Optional<RecordingFolder> folder) throws IOException {
    if (folder.isPresent()) {
      return new FlightReports(file, folder.get(), Optional.empty());
    }
    TemporaryFolder temporary = TemporaryFolder.create("tello-flights");
    return new FlightReports(file, RecordingFolder.at(temporary.path()), Optional.of(temporary));
  }

  /** The folder in which the flights must be recorded. */
  public RecordingFolder recordings() {
    return recordings;
  }

  /**
   * Writes the reports. Must be called after the last recording is closed. A second call does
   * nothing.
   *
   * @param told receives the file of each report
   * @param failed receives a sentence for users if a report cannot be written
   * @return whether all reports were written
   */
  public synchronized boolean write(
      Supplier<ReportTexts> texts, Consumer<Path> told, Consumer<String> failed) {
    if (written) {
      return true;
    }
    written = true;
    List<Path> folders = recordings.made();
    boolean all = true;
    for (int i = 0; i < folders.size(); i++) {
      all &= write(folders.get(i), numbered(i + 1), texts.get(), told, failed);
    }
    if (folders.isEmpty()) {
      failed.accept("There is no report, because no drone took off.");
    }
    temporary.ifPresent(TemporaryFolder::close);
    return all;
  }

  private static boolean write(
      Path folder, Path to, ReportTexts texts, Consumer<Path> told, Consumer<String> failed) {
    try {
      new FlightReport(RecordedFlight.read(folder), texts).write(to);
      told.accept(to);
      return true;
    } catch (UnreadableRecordingException e) {
      failed.accept(e.getMessage());
    } catch (IOException e) {
      failed.accept(notWritten(to, e));
    }
    return false;
  }

  /** Returns a sentence that tells users that a report was not written, and why. */
  public static String notWritten(Path file, IOException e) {
    return "The report was not written to " + file + ": " + IoReason.of(e) + ".";
  }

  /** Returns the report file for a flight: {@code flight.html}, {@code flight-2.html} and so on. */
  Path numbered(int number) {
    String name = file.getFileName().toString();
    int dot = name.lastIndexOf('.');
    String stem = dot > 0 ? name.substring(0, dot) : name;
    String end = dot > 0 ? name.substring(dot) : "";
    return number == 1 ? file : file.resolveSibling(stem + "-" + number + end);
  }
}
