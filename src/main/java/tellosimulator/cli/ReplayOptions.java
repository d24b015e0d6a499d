package tellosimulator.cli;

import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

/** The options that open the window on recordings. */
final class ReplayOptions {

  private static final String REPLAY = "--replay";

  private static final String GHOST = "--ghost";

  /** What may stand beside: all others are about a flight, and nothing is flown. */
  private static final Set<String> COMPANIONS =
      Set.of(REPLAY, GHOST, Options.CAMERA_FOV, Options.CAMERA_TILT, Options.LOG_LEVEL);

  private final OptionList optionList;
  private final OptionValue<Optional<Path>> folder;
  private final OptionValue<Optional<Path>> ghost;

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
  void check() {
    if (folder().isEmpty()) {
      if (ghost().isPresent()) {
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
