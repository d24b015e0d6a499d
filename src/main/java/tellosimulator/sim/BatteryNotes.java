package tellosimulator.sim;

import java.util.Optional;
import java.util.Set;
import tellosimulator.model.Battery;
import tellosimulator.words.Phrase;

/** Creates the log messages about a low battery. */
final class BatteryNotes {

  /**
   * The charges at which a message is logged [%]. From the highest to the lowest: the drone can no
   * longer flip, will soon be unable to take off, can no longer take off, lands automatically.
   */
  private static final Set<Integer> TOLD =
      Set.of(
          Battery.LEAST_FOR_FLIP - 1,
          2 * Battery.TOO_LOW_FOR_TAKEOFF,
          Battery.TOO_LOW_FOR_TAKEOFF,
          Battery.LANDS_BY_ITSELF);

  private BatteryNotes() {}

  /**
   * Returns the message about a change of charge.
   *
   * @param before the previous charge [%]
   * @param left the current charge [%]
   * @return the message; empty if the charge has not changed, or if its new value has no message
   */
  static Optional<Phrase> note(int before, int left) {
    return left != before && TOLD.contains(left)
        ? Optional.of(Phrase.of("has %d %% of its battery left", left))
        : Optional.empty();
  }
}
