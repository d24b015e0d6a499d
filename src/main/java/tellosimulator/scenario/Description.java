package tellosimulator.scenario;

import java.util.Optional;

/**
 * What a scenario says about itself to people. Immutable; for any thread.
 *
 * @param name what it is called; may be empty
 * @param teaches one line on what one learns by it; may be empty
 * @param difficulty how hard it is, as far as it is said
 */
public record Description(
    LocalizedText name, LocalizedText teaches, Optional<Difficulty> difficulty) {

  /** Nothing. */
  public static final Description NONE =
      new Description(LocalizedText.NONE, LocalizedText.NONE, Optional.empty());
}
