package tellosimulator.view.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Predicate;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.FlightReport;
import tellosimulator.report.ReportTexts;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogQueue;
import tellosimulator.view.log.ReportOffer;
import tellosimulator.words.Translation;

/**
 * The report of the latest recorded flight. A separate thread writes it into the recording's folder
 * and opens it; the outcome is logged. Confined to the JavaFX thread.
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
      recordings.latest().ifPresent(folder -> begin(folder, chosen));
    }
  }

  private void begin(Path folder, Translation chosen) {
    writing = true;
    availability.set(Availability.WRITING);
    Worker.once(
        "report",
        FAILED,
        () -> {
          try {
            writeAndOpen(folder, chosen);
          } catch (RuntimeException | Error e) {
            say(LogLevel.ERROR, "report-failed", folder);
            throw e;
          } finally {
            writing = false;
          }
        });
  }

  private void writeAndOpen(Path folder, Translation chosen) {
    Path file = folder.resolve(FlightReport.FILE_NAME);
    try {
      new FlightReport(RecordedFlight.read(folder), new ReportTexts(chosen)).write(file);
    } catch (UnreadableRecordingException e) {
      logQueue.say(LogLevel.ERROR, language -> e.getMessage());
      return;
    } catch (IOException e) {
      logQueue.say(
          LogLevel.ERROR,
          language ->
              language
                  .messages(LastFlightReport.class)
                  .now("report-not-written", file, language.reason(e)));
      return;
    }
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
