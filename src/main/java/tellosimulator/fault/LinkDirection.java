package tellosimulator.fault;

import java.util.Locale;

/** The kind of traffic on the link between a drone and its operator. */
public enum LinkDirection {
  /** Commands, from any sender to the drone. */
  COMMANDS,
  /** Replies, from the drone to the sender of the command. */
  REPLIES,
  /** State lines, from the drone to its operator. */
  STATE,
  /** Video frames, from the drone to its operator. */
  VIDEO;

  /** Returns the word that stands for this direction in the text of a fault. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
