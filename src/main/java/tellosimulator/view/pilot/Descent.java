package tellosimulator.view.pilot;

import java.util.Optional;
import tellosimulator.model.FlightPhase;
import tellosimulator.profile.Sdk;
import tellosimulator.view.model.FxDroneModel;

/**
 * Lands a drone, whatever it is doing: {@code stop} ends the current command, and {@code land} is
 * repeated until the drone accepts it. Confined to the JavaFX thread.
 */
final class Descent {

  /**
   * Time between two attempts [ns]. Assumed: a drone that accepts {@code land} begins to land
   * within this time.
   */
  private static final long RETRY_NANOS = 300_000_000;

  /**
   * Time for which the motors must have been off [ns]. Assumed: a takeoff that has just been
   * commanded starts within this time.
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
   * Sends the commands that are due at a UI tick. Returns whether the motors have been off for so
   * long that the drone counts as landed.
   *
   * @param nanos the time of the tick [ns]
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
