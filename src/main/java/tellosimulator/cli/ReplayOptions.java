package tellosimulator.cli;

import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/** The command-line options for showing recordings in the window. */
final class ReplayOptions {

  private static final String REPLAY = "--replay";

  private static final String GHOST = "--ghost";

  /**
   * The options that may be combined with a replay. All other options concern a new flight, and a
   * replay only shows a recorded one.
   */
  private static final Set<String> COMPANIONS =
      Set.of(REPLAY, GHOST, Options.CAMERA_FOV, Options.CAMERA_TILT, Options.LOG_LEVEL);

  private final OptionList optionList;

  /** The recording to show; empty if not given. */
  final OptionValue<Optional<Path>> folder;

  /** The second recording to show together with the first one; empty if not given. */
  final OptionValue<Optional<Path>> ghost;

  ReplayOptions(OptionList optionList) {
    this.optionList = optionList;
    folder =
        optionList
            .option(
                REPLAY,
                "FOLDER",
                "Open the window on a recorded flight, to play, pause and scrub; nothing is flown.")
            .readIfGiven(OptionTypes::recording);
    ghost =
        optionList
            .option(
                GHOST,
                "FOLDER",
                "With --replay: show a second recorded flight as translucent drones beside the"
                    + " first, from the takeoff on.")
            .readIfGiven(OptionTypes::recording);
  }

  /**
   * Checks that the options are consistent.
   *
   * @throws IllegalArgumentException if they are inconsistent; the message is one sentence
   */
  void check() {
    if (folder.value().isEmpty()) {
      if (ghost.value().isPresent()) {
        throw new IllegalArgumentException(GHOST + " needs " + REPLAY);
      }
      return;
    }
    if (optionList.given().contains(Options.HEADLESS)) {
      throw new IllegalArgumentException(
          REPLAY
              + " shows a flight in a window; without one, replay FOLDER flies it again, and report"
              + " FOLDER makes a page of it, which any browser shows");
    }
    for (String option : optionList.given()) {
      if (!COMPANIONS.contains(option)) {
        throw new IllegalArgumentException(option + " does not go with " + REPLAY);
      }
    }
  }
}
