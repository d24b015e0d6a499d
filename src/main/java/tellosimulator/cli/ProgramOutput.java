package tellosimulator.cli;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.function.Supplier;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.words.Translation;

/**
 * Where the program writes to, and in which language; and what a person says to it. For one thread.
 *
 * @param out takes results
 * @param err takes sentences about what went wrong
 * @param help takes the help, which may have colors
 * @param translation finds the language of the program, which takes a file to be read
 * @param input what comes from a person meanwhile
 */
public record ProgramOutput(
    PrintStream out,
    PrintStream err,
    PrintStream help,
    Supplier<Translation> translation,
    ProgramInput input) {

  /** Prints what is missing of a recording. */
  void printRemarks(Path folder, RecordedFlight flight) {
    flight.remarks().forEach(remark -> out.println("remark: " + folder + ": " + remark.english()));
  }
}
