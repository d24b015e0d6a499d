package tellosimulator.command;

import tellosimulator.profile.Behavior;

/** What becomes of a command that arrives while another one runs. Report: there is no queue. */
public enum BusyRule {
  /** Refused. */
  REFUSED("refused"),
  /** Carried out at any time: {@code rc}, {@code stop} and {@code emergency}. */
  ALLOWED("carried out"),
  /** Reads and {@code command}. */
  READ("refused; behaviour `measured`: answered"),
  /** {@code land}. */
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

  /** For the protocol page. */
  public String words() {
    return words;
  }
}
