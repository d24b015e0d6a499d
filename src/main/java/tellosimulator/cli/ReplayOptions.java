package tellosimulator.cli;

import java.nio.file.Path;
import java.util.Optional;

/** The options that open the window on recordings. */
final class ReplayOptions {

  private static final String REPLAY = "--replay";

  private static final String GHOST = "--ghost";

  private final Choice<Optional<Path>> folder;
  private final Choice<Optional<Path>> ghost;

  ReplayOptions(Choices choices) {
    folder =
        choices
            .option(
                REPLAY,
                "FOLDER",
                "Open the window on a recorded flight, to play, pause and scrub; nothing is flown.")
            .readIfGiven(OptionTypes::path);
    ghost =
        choices
            .option(
                GHOST,
                "FOLDER",
                "With --replay: show a second recorded flight as translucent drones beside the"
                    + " first, from the takeoff on.")
            .readIfGiven(OptionTypes::path);
  }

  /** The recording to be looked at; empty if nobody said one. */
  Optional<Path> folder() {
    return folder.value();
  }

  /** The recording that it is compared with; empty if nobody said one. */
  Optional<Path> ghost() {
    return ghost.value();
  }

  /**
   * Looks whether the options fit together.
   *
   * @throws IllegalArgumentException with a sentence, if they do not
   */
  void check(boolean headless, boolean exitWhenDone) {
    if (ghost().isPresent() && folder().isEmpty()) {
      throw new IllegalArgumentException(GHOST + " needs " + REPLAY);
    }
    if (folder().isPresent() && headless) {
      throw new IllegalArgumentException(
          REPLAY
              + " shows a flight in a window; without one, report FOLDER makes a page of it, which"
              + " any browser shows");
    }
    if (folder().isPresent() && exitWhenDone) {
      throw new IllegalArgumentException(
          ScenarioOptions.EXIT_WHEN_DONE + " does not go with " + REPLAY);
    }
  }
}
