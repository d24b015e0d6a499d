package tellosimulator.sim;

import java.util.Optional;
import java.util.Set;
import tellosimulator.model.Battery;
import tellosimulator.words.Phrase;

/** Makes the notes for people about a battery that empties. */
final class BatteryNotes {

  /** Percentages worth a line: no flip, soon no takeoff, no takeoff, lands by itself. */
  private static final Set<Integer> TOLD =
      Set.of(
          Battery.LEAST_FOR_FLIP - 1,
          2 * Battery.TOO_LOW_FOR_TAKEOFF,
          Battery.TOO_LOW_FOR_TAKEOFF,
          Battery.LANDS_BY_ITSELF);

  private BatteryNotes() {}

  /**
   * The note about a change.
   *
   * @param before what was left [%]
   * @param left what is left now [%]
   * @return empty for most percentages
   */
  static Optional<Phrase> note(int before, int left) {
    return left != before && TOLD.contains(left)
        ? Optional.of(Phrase.of("has %d %% of its battery left", left))
        : Optional.empty();
  }
}
