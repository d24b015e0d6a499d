package tellosimulator.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.comparison.ComparisonTable;
import tellosimulator.comparison.FlightComparison;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.Tolerance;
import tellosimulator.files.IoReason;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.ComparisonReport;
import tellosimulator.report.ComparisonReport.NamedFlight;
import tellosimulator.report.FlightReports;
import tellosimulator.report.ReportTexts;

/** Compares two recordings. Not thread-safe. */
final class DiffSubcommand extends Subcommand {

  private final Supplier<Path> first = optionList.recording("A");
  private final Supplier<Path> second = optionList.recording("B");

  private final OptionValue<Optional<Path>> output =
      optionList.output("Also write the table and charts of both as an HTML file.");

  DiffSubcommand() {
    super(
        SubcommandName.DIFF,
        "Compares two recorded flights, command by command: replies, durations, and how the"
            + " drones moved as their state lines tell it.",
        "Exit code 0: alike; 4: they differ; 1: cannot be read or written; 2: wrong options.");
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    return () -> run(to);
  }

  private int run(ProgramOutput to) throws UnreadableRecordingException {
    Optional<Flight> one = read(first.get(), to);
    Optional<Flight> other = one.isPresent() ? read(second.get(), to) : Optional.empty();
    return other.isPresent() ? compare(one.get(), other.get(), to) : ExitCode.FAILED;
  }

  /**
   * Reads a recording and prints the remarks about it. If an I/O error occurs, prints a message and
   * returns empty.
   */
  private static Optional<Flight> read(Path folder, ProgramOutput to)
      throws UnreadableRecordingException {
    try {
      Flight flight = Flight.read(folder);
      to.printRemarks(folder, flight.recording());
      return Optional.of(flight);
    } catch (IOException e) {
      to.err().println(folder + " cannot be read: " + IoReason.ofReading(e) + ".");
      return Optional.empty();
    }
  }

  private int compare(Flight one, Flight other, ProgramOutput to) {
    FlightComparison comparison = FlightComparison.of(one, other, Tolerance.DEFAULT);
    if (comparison.pairs().isEmpty()) {
      to.err().println("There is nothing to compare: neither flight has a command besides rc.");
      return ExitCode.FAILED;
    }
    new ComparisonTable(comparison, Tolerance.DEFAULT).print(to.out());
    if (output.value().isPresent() && !write(output.value().get(), one, other, to)) {
      return ExitCode.FAILED;
    }
    return comparison.alike() ? ExitCode.DONE : ExitCode.FLIGHTS_DIFFER;
  }

  /** Writes the comparison page; returns whether writing succeeded. */
  private boolean write(Path file, Flight one, Flight other, ProgramOutput to) {
    try {
      new ComparisonReport(
              NamedFlight.of(first.get(), one),
              NamedFlight.of(second.get(), other),
              Tolerance.DEFAULT,
              new ReportTexts(to.translation().get()))
          .write(file);
    } catch (IOException e) {
      to.err().println(FlightReports.notWritten(file, e));
      return false;
    }
    to.out().println("report: " + file);
    return true;
  }
}
