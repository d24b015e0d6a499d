package tellosimulator.sim;

import java.util.Optional;
import tellosimulator.controller.FlightEvent;
import tellosimulator.words.Phrase;

/**
 * The hint that explains why drones land automatically at time factor {@code max}. It is given only
 * once, after the first such landing. Confined to the simulation thread.
 */
final class SilenceHint {

  private boolean given;

  /**
   * Returns the hint if an event calls for it.
   *
   * @param unlimited whether time passes as fast as possible
   * @return the hint; empty if it has already been given, or does not apply
   */
  Optional<Phrase> after(SimEvent event, boolean unlimited) {
    boolean silence =
        event instanceof SimEvent.DroneFlight flight
            && flight.event() instanceof FlightEvent.LandsByItself landing
            && landing.cause() == FlightEvent.LandingCause.SILENCE;
    if (!silence || !unlimited || given) {
      return Optional.empty();
    }
    given = true;
    return Optional.of(
        Phrase.of(
            "with time factor max a drone is soon without commands for 15 s, because they pass"
                + " in an instant while another one flies; --no-safety-landing keeps it in the"
                + " air"));
  }
}
