package tellosimulator.sim;

import java.util.Optional;
import tellosimulator.controller.FlightEvent;
import tellosimulator.words.Phrase;

/**
 * Explains once why drones land by themselves as fast as possible, which surprises people. For the
 * simulation thread.
 */
final class SilenceHint {

  private boolean given;

  /**
   * What is to be said after something happened.
   *
   * @param unlimited whether time passes as fast as possible
   * @return empty if it was said already, or if there is nothing to explain
   */
  Optional<Phrase> after(SimEvent event, boolean unlimited) {
    boolean silence =
        event instanceof SimEvent.DroneFlight flight
            && flight.event() instanceof FlightEvent.LandsByItself landing
            && landing.silence();
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
