package tellosimulator.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Optional;
import tellosimulator.files.IoReason;

/** The options that say where flights are recorded, and where their report goes. */
final class RecordingOptions {

  static final String RECORD = "--record";

  private static final String REPORT = "--report";

  private final OptionValue<Optional<Path>> folder;
  private final OptionValue<Optional<Path>> report;

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
  }

  /** The folder in which flights are recorded; empty if nobody said one. */
  Optional<Path> folder() {
    return folder.value();
  }

  /** The file of the report; empty if nobody said one. */
  Optional<Path> report() {
    return report.value();
  }

  /**
   * Looks whether flights can be recorded there, and makes the folder; and whether the report can
   * be written, which must not be over a file that the flight begins from.
   *
   * @param inputs the scenario and its pictures
   * @throws IllegalArgumentException with a sentence, if they cannot
   */
  void check(boolean headless, Collection<Path> inputs) {
    folder().ifPresent(RecordingOptions::check);
    if (report().isPresent() && !headless) {
      throw new IllegalArgumentException(REPORT + " needs --headless");
    }
    report().ifPresent(file -> checkFile(file, inputs));
  }

  private static void checkFile(Path file, Collection<Path> inputs) {
    if (inputs.stream().anyMatch(input -> isSame(input, file))) {
      throw new IllegalArgumentException(
          REPORT + " " + file + ": the simulator reads this file, which would be lost");
    }
    Path within = file.toAbsolutePath().getParent();
    if (Files.isDirectory(file) || within == null || !Files.isDirectory(within)) {
      throw new IllegalArgumentException(
          Files.isDirectory(file)
              ? REPORT + " " + file + ": expected a file, found a folder"
              : REPORT + " " + file + ": there is no folder " + within);
    }
  }

  private static boolean isSame(Path one, Path other) {
    try {
      return Files.isSameFile(one, other);
    } catch (IOException e) {
      return false; // one is not there
    }
  }

  /**
   * Looks whether flights can be recorded there, and makes the folder.
   *
   * @throws IllegalArgumentException with a sentence, if they cannot
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
