package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.time.SimTime;

/** A drone that switches itself off and on again. For one drone and the simulation thread. */
final class Restart {

  /** From the notice to the restart [s]. Documented: "will reboot in 3s". */
  static final double NOTICE = 3;

  /** How long a drone that starts is silent [s]. Decided. */
  private static final double SILENCE = 8;

  private Optional<SimTime> offAt = Optional.empty();
  private Optional<SimTime> onAt = Optional.empty();

  /** Plans a restart, unless one is on its way. */
  void schedule(SimTime now, double notice) {
    if (!pending()) {
      offAt = Optional.of(now.plus(notice));
    }
  }

  boolean pending() {
    return offAt.isPresent() || onAt.isPresent();
  }

  void forget() {
    offAt = Optional.empty();
    onAt = Optional.empty();
  }

  void advance(SimTime now, Runnable powerOff, Runnable powerOn) {
    if (offAt.isPresent() && !now.isBefore(offAt.get())) {
      powerOff.run();
      offAt = Optional.empty();
      onAt = Optional.of(now.plus(SILENCE));
    }
    if (onAt.isPresent() && !now.isBefore(onAt.get())) {
      onAt = Optional.empty();
      powerOn.run();
    }
  }
}
