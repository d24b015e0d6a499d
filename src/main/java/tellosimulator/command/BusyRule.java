package tellosimulator.command;

import tellosimulator.profile.Behavior;

/**
 * The treatment of a command that arrives while another one is running. Report: the drone does not
 * queue commands.
 */
public enum BusyRule {
  /** The drone refuses the command. */
  REFUSED("refused"),
  /** The drone always carries out the command: {@code rc}, {@code stop} and {@code emergency}. */
  ALLOWED("carried out"),
  /**
   * The drone answers the command if {@link Behavior#readsWhileBusy} is true, and refuses it
   * otherwise: read commands, {@code EXT} commands and {@code command}.
   */
  READ("refused; behaviour `measured`: answered"),
  /**
   * The drone carries out {@code land} if {@link Behavior#landsWhileBusy} is true, and refuses it
   * otherwise.
   */
  LAND("refused; behaviour `measured`: carried out, the other answers `error Auto land`");

  private final String words;

  BusyRule(String words) {
    this.words = words;
  }

  boolean allows(Behavior behavior) {
    return switch (this) {
      case REFUSED -> false;
      case ALLOWED -> true;
      case READ -> behavior.readsWhileBusy();
      case LAND -> behavior.landsWhileBusy();
    };
  }

  /** Returns the description of the rule on the protocol page. */
  public String words() {
    return words;
  }
}
