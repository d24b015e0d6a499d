package tellosimulator.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.comparison.ComparisonTable;
import tellosimulator.comparison.FlightComparison;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.Tolerance;
import tellosimulator.files.IoReason;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.replay.Difference;
import tellosimulator.replay.Repetition;
import tellosimulator.replay.Replay;

/** Replays a recorded flight and reports whether the new recording is the same. Not thread-safe. */
final class ReplaySubcommand extends Subcommand {

  /** Maximum length of a differing line in the output [characters]; longer lines are truncated. */
  private static final int LONGEST = 300;

  private final Supplier<Path> folder = optionList.recording("FOLDER");

  private final OptionValue<Optional<Path>> record =
      optionList
          .option(
              RecordingOptions.RECORD,
              "DIR",
              "Keep the second recording, in a folder of its own in DIR.")
          .readIfGiven(OptionTypes::fileOrFolder);

  ReplaySubcommand() {
    super(
        SubcommandName.REPLAY,
        "Flies a recorded flight again, with the same inputs after the same steps, and compares"
            + " both recordings byte by byte.",
        "Exit code 0: identical, or alike if only commands could be flown again; 4: they differ;"
            + " 1: cannot be read or written; 2: wrong options.");
  }

  @Override
  public Invocation.Action action(ProgramOutput to) {
    return () -> run(to);
  }

  private int run(ProgramOutput to) throws UnreadableRecordingException {
    Path from = folder.get();
    Replay replay;
    try {
      replay = Replay.of(from);
    } catch (IOException e) {
      to.err().println(from + " cannot be read: " + IoReason.ofReading(e) + ".");
      return ExitCode.FAILED;
    }
    if (record.value().isPresent()) {
      return repeat(replay, record.value().get(), to);
    }
    try (TemporaryFolder temporary = TemporaryFolder.create("tello-replay")) {
      to.input().atEnd().accept(temporary::close);
      return repeat(replay, temporary.path(), to);
    } catch (IOException e) {
      to.err().println("There is no place for the second recording: " + IoReason.of(e) + ".");
      return ExitCode.FAILED;
    }
  }

  private int repeat(Replay replay, Path into, ProgramOutput to)
      throws UnreadableRecordingException {
    try {
      return repeat(replay, into, to.out());
    } catch (IOException e) {
      to.err().println("The flight was not flown again: " + IoReason.of(e, into) + ".");
      return ExitCode.FAILED;
    }
  }

  private int repeat(Replay replay, Path into, PrintStream out)
      throws UnreadableRecordingException, IOException {
    Repetition repetition = replay.repeat(RecordingFolder.at(into));
    repetition.remarks().forEach(remark -> out.println("remark: " + remark.english()));
    if (record.value().isPresent()) {
      out.println("recorded: " + repetition.recording());
    }
    if (repetition.identical()) {
      out.println("identical");
      return ExitCode.DONE;
    }
    if (repetition.exact()) {
      out.println("The flights differ:");
      repetition.differences().forEach(difference -> print(difference, out));
    }
    FlightComparison comparison =
        FlightComparison.of(
            Flight.read(folder.get()), Flight.read(repetition.recording()), Tolerance.DEFAULT);
    new ComparisonTable(comparison, Tolerance.DEFAULT).print(out);
    return !repetition.exact() && comparison.alike() ? ExitCode.DONE : ExitCode.FLIGHTS_DIFFER;
  }

  private static void print(Difference difference, PrintStream out) {
    String when =
        difference.time().isPresent()
            ? String.format(Locale.ROOT, ", at %.3f s", difference.time().getAsDouble())
            : "";
    out.println("  " + difference.file() + ", line " + difference.line() + when);
    out.println("    recorded: " + shown(difference.recorded()));
    out.println("    replayed: " + shown(difference.replayed()));
  }

  private static String shown(String line) {
    return line.isEmpty()
        ? "nothing"
        : line.length() > LONGEST ? line.substring(0, LONGEST) + "..." : line;
  }
}
