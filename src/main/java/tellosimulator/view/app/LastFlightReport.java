package tellosimulator.view.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.grade.Grades;
import tellosimulator.grade.Regrading;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.ClassReport;
import tellosimulator.report.FlightReport;
import tellosimulator.report.ReportTexts;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.log.ReportOffer;
import tellosimulator.words.Translation;

/**
 * The report of the latest recorded flight, and the page with its points. A separate thread writes
 * them into the recording's folder and opens them; the outcome is logged. Confined to the JavaFX
 * thread.
 */
final class LastFlightReport implements ReportOffer {

  private static final ErrorPolicy FAILED = ErrorPolicy.finish("The report of a flight failed");

  private final RecordingFolder recordings;
  private final LogQueue logQueue;
  private final Predicate<Path> opener;
  private final ReadOnlyObjectWrapper<Availability> availability =
      new ReadOnlyObjectWrapper<>(this, "availability", Availability.NO_FLIGHT);
  private Translation translation = Translation.ENGLISH;
  private volatile boolean writing;

  /**
   * @param opener opens a file for the user and returns whether this succeeded; called on the
   *     thread that wrote the file
   */
  LastFlightReport(RecordingFolder recordings, LogQueue logQueue, Predicate<Path> opener) {
    this.recordings = recordings;
    this.logQueue = logQueue;
    this.opener = opener;
  }

  /**
   * Updates the availability of the report. Must be called once per pulse.
   *
   * @param recorded whether flights are recorded
   * @param newTranslation the translation for the report's text
   */
  void update(boolean recorded, Translation newTranslation) {
    translation = newTranslation;
    availability.set(availability(recorded));
  }

  private Availability availability(boolean recorded) {
    if (writing) {
      return Availability.WRITING;
    }
    if (recordings.latest().isPresent()) {
      return Availability.READY;
    }
    if (!recordings.made().isEmpty()) {
      return Availability.IN_FLIGHT;
    }
    return recorded ? Availability.NO_FLIGHT : Availability.NOT_RECORDED;
  }

  @Override
  public ReadOnlyObjectProperty<Availability> availabilityProperty() {
    return availability.getReadOnlyProperty();
  }

  @Override
  public void open() {
    Translation chosen = translation;
    if (!writing) {
      recordings.latest().ifPresent(folder -> begin(folder, () -> writeReport(folder, chosen)));
    }
  }

  /**
   * Grades the flight, and opens the page with its points; the outcome is logged.
   *
   * @param assignment the file of the assignment
   */
  void grade(Path assignment) {
    Translation chosen = translation;
    if (availability.get() == Availability.READY) {
      Path folder = recordings.latest().orElseThrow();
      begin(folder, () -> grade(folder, assignment, chosen));
    } else {
      say(LogLevel.WARN, "no-flight-to-grade", assignment);
    }
  }

  /** Writes a page. */
  @FunctionalInterface
  private interface Writer {

    /**
     * @return the page; empty if there is none, for which the reason was logged
     */
    Optional<Path> write() throws UnreadableRecordingException, IOException;
  }

  private Optional<Path> writeReport(Path folder, Translation chosen)
      throws UnreadableRecordingException, IOException {
    Path file = folder.resolve(FlightReport.FILE_NAME);
    new FlightReport(RecordedFlight.read(folder), new ReportTexts(chosen)).write(file);
    return Optional.of(file);
  }

  private Optional<Path> grade(Path folder, Path assignment, Translation chosen)
      throws UnreadableRecordingException, IOException {
    try {
      Optional<Grades> grades = Regrading.grade(folder, assignment);
      if (grades.isEmpty()) {
        say(LogLevel.ERROR, "not-a-course", assignment);
        return Optional.empty();
      }
      new ClassReport(grades.get(), folder, new ReportTexts(chosen)).writeFeedback();
      return Optional.of(folder.resolve(ClassReport.FEEDBACK));
    } catch (ScenarioException e) {
      e.diagnostics()
          .forEach(
              each -> logQueue.say(LogLevel.ERROR, language -> each.in(language.translation())));
      return Optional.empty();
    }
  }

  private void begin(Path folder, Writer writer) {
    writing = true;
    availability.set(Availability.WRITING);
    Worker.once(
        "report",
        FAILED,
        () -> {
          try {
            writeAndOpen(folder, writer);
          } catch (RuntimeException | Error e) {
            say(LogLevel.ERROR, "report-failed", folder);
            throw e;
          } finally {
            writing = false;
          }
        });
  }

  private void writeAndOpen(Path folder, Writer writer) {
    try {
      writer.write().ifPresent(this::show);
    } catch (UnreadableRecordingException e) {
      logQueue.say(LogLevel.ERROR, language -> e.getMessage());
    } catch (IOException e) {
      logQueue.say(
          LogLevel.ERROR,
          language ->
              language
                  .messages(LastFlightReport.class)
                  .now("report-not-written", folder, language.reason(e)));
    }
  }

  private void show(Path file) {
    if (opener.test(file)) {
      say(LogLevel.INFO, "report-opened", file);
    } else {
      say(LogLevel.WARN, "report-written", file);
    }
  }

  private void say(LogLevel level, String key, Path about) {
    logQueue.say(level, language -> language.messages(LastFlightReport.class).now(key, about));
  }
}
