package tellosimulator.model;

/** The flight phase of a drone, by what its motors do. For any thread. */
public enum FlightPhase {
  /** Without power. */
  OFF("off", false, false),
  /** On the floor or on an obstacle, motors off. */
  GROUNDED("standing", false, false),
  /** On the floor or on an obstacle, propellers turning slowly ({@code motoron}). */
  IDLING("standing, motors idling", true, false),
  TAKING_OFF("taking off", true, true),
  FLYING("flying", true, true),
  LANDING("landing", true, true),
  /** Motors off in the air, after {@code emergency} or with an empty battery. */
  FALLING("falling", false, false),
  /** Motors off until reset or power cycle. */
  CRASHED("crashed", false, false);

  private final String words;
  private final boolean motorsOn;
  private final boolean flying;

  FlightPhase(String words, boolean motorsOn, boolean flying) {
    this.words = words;
    this.motorsOn = motorsOn;
    this.flying = flying;
  }

  /** For people. */
  public String words() {
    return words;
  }

  public boolean motorsOn() {
    return motorsOn;
  }

  /** Whether something of the drone moves: its propellers, or itself. */
  public boolean moving() {
    return motorsOn || this == FALLING;
  }

  /** Whether the motors carry the drone. */
  public boolean flying() {
    return flying;
  }
}
