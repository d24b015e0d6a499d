package tellosimulator.view.log;

import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.view.text.Language;

/**
 * A line of the log. Immutable; its words are made anew for each language.
 *
 * @param time in the simulation
 * @param about which drone
 * @param saying what happened
 */
record LogLine(SimTime time, LogLevel level, About about, Saying saying) {

  /**
   * What a line is about.
   *
   * @param drone its number, from 1; 0 for what concerns all of them, or the window
   * @param subject whether the drone is the subject that the words lack
   */
  record About(int drone, boolean subject) {

    /** All drones, or the window. */
    static final About ALL = new About(0, false);

    /** A drone of which the words say something. */
    static About subject(int drone) {
      return new About(drone, drone > 0);
    }
  }

  /** Something that can be said in each language. */
  @FunctionalInterface
  interface Saying {
    String in(Language language);
  }

  /** What happened in the simulation. */
  static LogLine of(SimEvent event) {
    return new LogLine(
        event.time(),
        LogLevel.of(event.severity()),
        new About(event.drone(), event.ofDrone()),
        language -> language.say(event.phrase()));
  }

  /** See {@link About}. */
  int drone() {
    return about.drone();
  }

  /** For people, without time, level and drone. */
  String words(Language language) {
    return saying.in(language);
  }
}
