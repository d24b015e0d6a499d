package tellosimulator.view.log;

import java.util.OptionalInt;
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
   * @param drone its number, from 1; empty for what concerns all of them, or the window
   * @param subject whether the drone is the subject that the words lack
   */
  record About(OptionalInt drone, boolean subject) {

    /** All drones, or the window. */
    static final About ALL = new About(OptionalInt.empty(), false);

    /**
     * A drone.
     *
     * @param drone its number, from 1
     */
    static About drone(int drone, boolean subject) {
      return new About(OptionalInt.of(drone), subject);
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
        event instanceof SimEvent.ForDrone one
            ? About.drone(one.drone(), one.lacksSubject())
            : About.ALL,
        language -> language.say(event.phrase()));
  }

  /** See {@link About}. */
  OptionalInt drone() {
    return about.drone();
  }

  /** For people, without time, level and drone. */
  String words(Language language) {
    return saying.in(language);
  }
}
