package tellosimulator.fault;

import java.util.Locale;

/** The kind of traffic on the link between a drone and its operator. For any thread. */
public enum LinkDirection {
  /** From whoever sends them to the drone. */
  COMMANDS,
  /** From the drone to whoever sent the command. */
  REPLIES,
  /** State lines, from the drone to its operator. */
  STATE,
  /** Pictures, from the drone to its operator. */
  VIDEO;

  /** The word in a fault's text. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
