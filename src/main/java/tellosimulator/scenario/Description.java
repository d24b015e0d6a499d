package tellosimulator.scenario;

import java.util.Optional;

/**
 * The description of a scenario for users. Immutable.
 *
 * @param name the name of the scenario; may be empty
 * @param teaches one line about the learning goal of the scenario; may be empty
 * @param difficulty the difficulty of the scenario, if given
 */
public record Description(
    LocalizedText name, LocalizedText teaches, Optional<Difficulty> difficulty) {

  /** An empty description. */
  public static final Description NONE =
      new Description(LocalizedText.NONE, LocalizedText.NONE, Optional.empty());
}
