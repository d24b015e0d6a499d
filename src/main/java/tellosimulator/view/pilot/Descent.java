package tellosimulator.view.pilot;

import java.util.Optional;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Sdk;
import tellosimulator.view.model.FxDroneModel;

/**
 * Brings a drone down, whatever it is doing: {@code stop} ends what runs, and {@code land} is
 * repeated until the drone takes it. For the JavaFX thread.
 */
final class Descent {

  /** From one attempt to the next [ns]. Assumed: a refusal has come by then. */
  private static final long RETRY_NANOS = 300_000_000;

  /**
   * How long the motors must be off [ns]. Assumed: a takeoff that was just commanded shows by then.
   */
  private static final long DOWN_NANOS = 200_000_000;

  private final FxDroneModel drone;
  private final OperatorClient pilot;
  private Optional<Long> lastTry = Optional.empty();
  private Optional<Long> downSince = Optional.empty();

  Descent(FxDroneModel drone, OperatorClient pilot) {
    this.drone = drone;
    this.pilot = pilot;
  }

  /**
   * Does what is to be done at a beat; whether the motors no longer carry the drone.
   *
   * @param nanos the beat's time [ns]
   */
  boolean isDown(long nanos) {
    FlightPhase phase = drone.phaseProperty().get();
    if (!phase.flying()) {
      downSince = downSince.or(() -> Optional.of(nanos));
      return nanos - downSince.get() >= DOWN_NANOS;
    }
    downSince = Optional.empty();
    if (phase != FlightPhase.LANDING
        && lastTry.filter(last -> nanos - last < RETRY_NANOS).isEmpty()) {
      lastTry = Optional.of(nanos);
      command();
    }
    return false;
  }

  private void command() {
    if (drone.snapshotProperty().get().product().profile().knows(Sdk.SDK_2_0)) {
      pilot.tell("stop");
    }
    pilot.tell("land");
  }
}
