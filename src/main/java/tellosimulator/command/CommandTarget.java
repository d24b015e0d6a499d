package tellosimulator.command;

import java.util.Optional;
import tellosimulator.words.Phrase;

/** Carries out valid commands. Called on the simulation thread. */
public interface CommandTarget {

  /** Returns the command that is being carried out, with its progress; empty if there is none. */
  Optional<Phrase> running();

  /** Whether the drone is in the air with its motors running, so that it can move. */
  boolean flying();

  /**
   * Returns the reason why the drone is not flying, and what to do about it. Called only while the
   * drone is not flying.
   */
  Phrase notFlying();

  /**
   * Returns the reason why the drone carries out only {@code command}; empty if it carries out all
   * commands.
   */
  default Optional<Phrase> unactivated() {
    return Optional.empty();
  }

  /**
   * Called when a host that may operate the drone sends a text. This proves that the link is alive.
   */
  void linkAlive();

  /**
   * Called when a host that may operate the drone sends a known command. This ends a safety
   * landing.
   */
  void commandArrived();

  /**
   * Carries out a command. The responder answers at once, later, or never if the real drone does
   * not answer either.
   */
  void carryOut(Command command, Responder responder);
}
