package tellosimulator.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Optional;
import tellosimulator.files.IoReason;

/** The command-line options for the recordings of flights and their reports. */
final class RecordingOptions {

  static final String RECORD = "--record";

  private static final String REPORT = "--report";
  private static final String RESULT = "--result";

  /** The folder in which flights are recorded; empty if not given. */
  final OptionValue<Optional<Path>> folder;

  /** The file of the report; empty if not given. */
  final OptionValue<Optional<Path>> report;

  /** The file of the result; empty if not given. */
  final OptionValue<Optional<Path>> result;

  RecordingOptions(OptionList optionList) {
    folder =
        optionList
            .option(
                RECORD,
                "DIR",
                "Record each flight into a folder of its own in DIR: what was sent, what happened,"
                    + " where the drones were, and what they filmed.")
            .readIfGiven(OptionTypes::fileOrFolder);
    report =
        optionList
            .option(
                REPORT,
                "FILE",
                "With --headless: at the end, make an HTML file of the flight; of a second one"
                    + " FILE-2, and so on. It opens in any browser, without a network.")
            .readIfGiven(OptionTypes::outputFile);
    result =
        optionList
            .option(
                RESULT,
                "FILE",
                "At the end, write a JSON file with the verdict, the goals, the points and why each"
                    + " was won or lost.")
            .readIfGiven(OptionTypes::outputFile);
  }

  /**
   * Checks that flights can be recorded, and creates the folder for recordings. Also checks that
   * the report and the result can be written without overwriting an input file.
   *
   * @param inputs the scenario and its pictures
   * @throws IllegalArgumentException if a check fails; the message is one sentence
   */
  void check(boolean headless, Collection<Path> inputs) {
    folder.value().ifPresent(RecordingOptions::check);
    if (report.value().isPresent() && !headless) {
      throw new IllegalArgumentException(REPORT + " needs --headless");
    }
    report.value().ifPresent(file -> checkFile(REPORT, file, inputs));
    result.value().ifPresent(file -> checkFile(RESULT, file, inputs));
    if (report.value().isPresent() && report.value().equals(result.value())) {
      throw new IllegalArgumentException(
          REPORT + " and " + RESULT + " name the same file, " + report.value().get());
    }
  }

  private static void checkFile(String option, Path file, Collection<Path> inputs) {
    if (inputs.stream().anyMatch(input -> isSame(input, file))) {
      throw new IllegalArgumentException(
          option + " " + file + ": the simulator reads this file, which would be lost");
    }
    Path within = file.toAbsolutePath().getParent();
    if (Files.isDirectory(file) || within == null || !Files.isDirectory(within)) {
      throw new IllegalArgumentException(
          Files.isDirectory(file)
              ? option + " " + file + ": expected a file, found a folder"
              : option + " " + file + ": there is no folder " + within);
    }
  }

  private static boolean isSame(Path one, Path other) {
    try {
      return Files.isSameFile(one, other);
    } catch (IOException e) {
      return false; // one of the files does not exist
    }
  }

  /**
   * Creates the folder for recordings, and checks that flights can be recorded in it.
   *
   * @throws IllegalArgumentException if they cannot be recorded; the message is one sentence
   */
  static void check(Path folder) {
    try {
      Files.createDirectories(folder);
      Files.delete(Files.createTempFile(folder, ".tello", ""));
    } catch (IOException e) {
      throw new IllegalArgumentException(
          RECORD + " " + folder + ": no flight can be recorded there: " + IoReason.of(e), e);
    }
  }
}
