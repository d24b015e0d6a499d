package tellosimulator.benchmark;

import java.util.Locale;

/** What the drone does in a part of the recorded flight. */
enum FlightPart {
  HOVER,
  /** At 50 cm/s. */
  FORWARD,
  /** To the right at 55 degrees a second. */
  TURN;

  /** As in the file. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
