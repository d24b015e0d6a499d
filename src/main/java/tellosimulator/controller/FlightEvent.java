package tellosimulator.controller;

import java.util.Locale;
import tellosimulator.math.Vec3;
import tellosimulator.world.Surface;

/** Something that happened to a drone, other than a command or a reply. */
public sealed interface FlightEvent {

  /** For people: a clause about the drone, such as {@code took off}. */
  String words();

  /** It left the ground. */
  record TookOff() implements FlightEvent {
    @Override
    public String words() {
      return "took off";
    }
  }

  /** It stands on the ground with its motors off. */
  record Landed() implements FlightEvent {
    @Override
    public String words() {
      return "landed";
    }
  }

  /**
   * It lands by itself.
   *
   * @param reason why, in plain words
   */
  record LandsByItself(String reason) implements FlightEvent {
    @Override
    public String words() {
      return "lands by itself: " + reason;
    }
  }

  /** A command ended a safety landing. */
  record LandingCancelled() implements FlightEvent {
    @Override
    public String words() {
      return "stays in the air, because a command arrived during the safety landing";
    }
  }

  /**
   * Its motors stopped in the air.
   *
   * @param reason why, in plain words
   */
  record Fell(String reason) implements FlightEvent {
    @Override
    public String words() {
      return "falls: " + reason;
    }
  }

  /**
   * It hit something too hard.
   *
   * @param surface what it hit
   * @param speed how fast [m/s]
   * @param position where, room frame [m]
   */
  record Crashed(Surface surface, double speed, Vec3 position) implements FlightEvent {
    @Override
    public String words() {
      return String.format(
          Locale.ROOT,
          "crashed into %s at %.1f m/s; its motors stay off until reset or power cycle",
          surface.words(),
          speed);
    }
  }

  /**
   * Something was set or switched.
   *
   * @param words what, as a clause about the drone
   */
  record Note(String words) implements FlightEvent {}
}
