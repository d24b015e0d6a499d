package tellosimulator.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.FlightReport;
import tellosimulator.report.FlightReports;
import tellosimulator.report.ReportTexts;

/** Writes an HTML report of a recording. Not thread-safe. */
final class ReportSubcommand extends Subcommand {

  private final Supplier<Path> folder = optionList.recording("FOLDER");

  private final OptionValue<Optional<Path>> output =
      optionList.output(
          "The file to write. Default: " + FlightReport.FILE_NAME + " in the folder.");

  ReportSubcommand() {
    super(
        SubcommandName.REPORT,
        "Makes a report of a recorded flight: one HTML file that opens in any browser,"
            + " without a network.",
        "Exit code 0: written; 1: cannot be read or written; 2: wrong options.");
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    return () -> run(to);
  }

  private int run(ProgramOutput to) throws UnreadableRecordingException {
    Path file = output.value().orElseGet(() -> folder.get().resolve(FlightReport.FILE_NAME));
    RecordedFlight flight = RecordedFlight.read(folder.get());
    to.printRemarks(folder.get(), flight);
    try {
      new FlightReport(flight, new ReportTexts(to.translation().get())).write(file);
    } catch (IOException e) {
      to.err().println(FlightReports.notWritten(file, e));
      return ExitCode.FAILED;
    }
    to.out().println("report: " + file);
    return ExitCode.DONE;
  }
}
