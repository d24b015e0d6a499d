package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.command.Reply;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneModel;
import tellosimulator.model.FlightPhase;
import tellosimulator.words.Phrase;

/** What keeps a drone from taking off. */
final class Preflight {

  /**
   * Why not.
   *
   * @param reason in plain words that follow "refused: "
   */
  record Objection(Reply reply, Phrase reason) {}

  private Preflight() {}

  /** Empty if it may take off. */
  static Optional<Objection> check(DroneModel model) {
    int percent = model.battery().percent();
    if (model.phase().flying()) {
      return objection(Reply.ERROR, Phrase.of("the drone flies already"));
    }
    if (model.phase() == FlightPhase.CRASHED) {
      return objection(Reply.MOTOR_STOP, Phrase.of("the drone has crashed, reset it first"));
    }
    if (model.battery().empty()) {
      return objection(Reply.MOTOR_STOP, Phrase.of("the battery is empty"));
    }
    if (percent <= Battery.TOO_LOW_FOR_TAKEOFF) {
      return objection(
          Reply.ERROR,
          Phrase.of(
              "the battery is at %d %%, a takeoff needs more than %d %%",
              percent, Battery.TOO_LOW_FOR_TAKEOFF));
    }
    if (!model.resting()) {
      return objection(Reply.ERROR, Phrase.of("the drone is still falling"));
    }
    return model.upright()
        ? Optional.empty()
        : objection(Reply.ERROR, Phrase.of("the drone lies on its back, reset it first"));
  }

  private static Optional<Objection> objection(Reply reply, Phrase reason) {
    return Optional.of(new Objection(reply, reason));
  }
}
