package tellosimulator.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.export.ExportFormat;
import tellosimulator.files.IoReason;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.UnreadableRecordingException;

/** Writes a recording in the format of another tool. Not thread-safe. */
final class ExportSubcommand extends Subcommand {

  private final Supplier<Path> folder = optionList.recording("FOLDER");

  private final Supplier<ExportFormat> format =
      optionList
          .option(
              "--to",
              Stream.of(ExportFormat.values())
                  .map(ExportFormat::word)
                  .collect(Collectors.joining("|")),
              "The format: pcap for Wireshark, mcap for Foxglove and PlotJuggler. flight.csv of the"
                  + " recording is a table already.")
          .readRequired(
              word -> OptionTypes.byName(word, ExportFormat.values(), ExportFormat::word));

  private final OptionValue<Optional<Path>> output =
      optionList.output("The file to write. Default: flight.pcap or flight.mcap in the folder.");

  ExportSubcommand() {
    super(
        SubcommandName.EXPORT,
        "Writes a recorded flight in the format of another tool.",
        "Exit code 0: written; 1: cannot be read or written; 2: wrong options.");
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    return () -> run(to);
  }

  private int run(ProgramOutput to) throws UnreadableRecordingException {
    Path from = folder.get();
    Path file = output.value().orElseGet(() -> from.resolve("flight." + format.get().word()));
    RecordedFlight flight = RecordedFlight.read(from);
    to.printRemarks(from, flight);
    try {
      format.get().export(from, flight, file);
    } catch (IOException e) {
      to.err()
          .println("The recording was not exported to " + file + ": " + IoReason.of(e, file) + ".");
      return ExitCode.FAILED;
    }
    to.out().println("exported: " + file);
    return ExitCode.DONE;
  }
}
