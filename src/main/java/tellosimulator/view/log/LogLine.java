package tellosimulator.view.log;

import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.view.text.Language;

/**
 * A line of the log. Immutable; its words are made anew for each language.
 *
 * @param time in the simulation
 * @param drone its number, from 1; 0 for what concerns all of them, or the window
 */
record LogLine(SimTime time, LogLevel level, int drone, Saying saying) {

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
        event.drone(),
        language -> language.say(event.phrase()));
  }

  /** For people, without time, level and drone. */
  String words(Language language) {
    return saying.in(language);
  }
}
