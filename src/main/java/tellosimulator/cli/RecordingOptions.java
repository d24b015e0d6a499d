package tellosimulator.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import tellosimulator.files.IoReason;

/** The option that says where flights are recorded. */
final class RecordingOptions {

  private static final String RECORD = "--record";

  private final Choice<Optional<Path>> folder;

  RecordingOptions(Choices choices) {
    folder =
        choices
            .option(
                RECORD,
                "DIR",
                "Record each flight into a folder of its own in DIR: what was sent, what happened,"
                    + " where the drones were, and what they filmed.")
            .readIfGiven(OptionTypes::path);
  }

  /** The folder in which flights are recorded; empty if nobody said one. */
  Optional<Path> folder() {
    return folder.value();
  }

  /**
   * Looks whether flights can be recorded there, and makes the folder.
   *
   * @throws IllegalArgumentException with a sentence, if they cannot
   */
  void check() {
    folder().ifPresent(RecordingOptions::check);
  }

  private static void check(Path folder) {
    try {
      Files.createDirectories(folder);
      Files.delete(Files.createTempFile(folder, ".tello", ""));
    } catch (IOException e) {
      throw new IllegalArgumentException(
          RECORD + " " + folder + ": no flight can be recorded there: " + IoReason.of(e), e);
    }
  }
}
