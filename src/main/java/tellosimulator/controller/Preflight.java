package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneModel;
import tellosimulator.model.FlightPhase;
import tellosimulator.words.Phrase;

/** Checks whether a drone can take off. */
final class Preflight {

  private Preflight() {}

  /** Returns the reason why a drone cannot take off; empty if it can. */
  static Optional<Result.Refused> check(DroneModel model) {
    int percent = model.battery().percent();
    if (model.phase().flying()) {
      return objection(RefusalKind.GENERAL, Phrase.of("the drone flies already"));
    }
    if (model.phase() == FlightPhase.CRASHED) {
      return objection(RefusalKind.MOTORS_OFF, Phrase.of("the drone has crashed, reset it first"));
    }
    if (model.battery().empty()) {
      return objection(RefusalKind.MOTORS_OFF, Phrase.of("the battery is empty"));
    }
    if (percent <= Battery.TOO_LOW_FOR_TAKEOFF) {
      return objection(
          RefusalKind.GENERAL,
          Phrase.of(
              "the battery is at %d %%, a takeoff needs more than %d %%",
              percent, Battery.TOO_LOW_FOR_TAKEOFF));
    }
    if (!model.resting()) {
      return objection(RefusalKind.GENERAL, Phrase.of("the drone is still falling"));
    }
    return model.upright()
        ? Optional.empty()
        : objection(RefusalKind.GENERAL, Phrase.of("the drone lies on its back, reset it first"));
  }

  private static Optional<Result.Refused> objection(RefusalKind kind, Phrase reason) {
    return Optional.of(new Result.Refused(kind, reason));
  }
}
