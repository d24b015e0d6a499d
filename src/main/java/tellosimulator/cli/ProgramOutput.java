package tellosimulator.cli;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.function.Supplier;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.words.Translation;

/**
 * The output streams, the language and the input of the program. Not thread-safe.
 *
 * @param out the stream for results
 * @param err the stream for error messages
 * @param help the stream for the help, which may contain colors
 * @param translation supplies the translation into the program's language; each call reads a file
 * @param input the program's input
 */
public record ProgramOutput(
    PrintStream out,
    PrintStream err,
    PrintStream help,
    Supplier<Translation> translation,
    ProgramInput input) {

  /** Prints the remarks about a recording. */
  void printRemarks(Path folder, RecordedFlight flight) {
    flight.remarks().forEach(remark -> out.println("remark: " + folder + ": " + remark.english()));
  }
}
