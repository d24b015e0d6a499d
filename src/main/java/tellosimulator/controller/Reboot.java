package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.time.SimTime;

/** Switches a drone off and on again. One instance per drone, confined to the simulation thread. */
final class Reboot {

  /** Time from the notice to the restart [s]. Documented: the reply says "will reboot in 3s". */
  static final double NOTICE = 3;

  /** Time from switching off to switching on, without any replies [s]. Decided. */
  private static final double SILENCE = 8;

  private Optional<SimTime> offAt = Optional.empty();
  private Optional<SimTime> onAt = Optional.empty();

  /** Schedules a restart, unless one is pending. */
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
