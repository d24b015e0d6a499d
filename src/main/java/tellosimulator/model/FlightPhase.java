package tellosimulator.model;

/** The phase of a flight, as determined by the motors. */
public enum FlightPhase {
  /** The drone has no power. */
  OFF("off", false, false),
  /** The drone is on the floor or on an obstacle, with its motors off. */
  GROUNDED("standing", false, false),
  /**
   * The drone is on the floor or on an obstacle, with its propellers turning slowly ({@code
   * motoron}).
   */
  IDLING("standing, motors idling", true, false),
  TAKING_OFF("taking off", true, true),
  FLYING("flying", true, true),
  LANDING("landing", true, true),
  /**
   * The motors stopped in the air, for example after {@code emergency} or because the battery is
   * empty.
   */
  FALLING("falling", false, false),
  /** The drone has crashed. The motors stay off until a reset or power cycle. */
  CRASHED("crashed", false, false);

  private final String words;
  private final boolean motorsOn;
  private final boolean flying;

  FlightPhase(String words, boolean motorsOn, boolean flying) {
    this.words = words;
    this.motorsOn = motorsOn;
    this.flying = flying;
  }

  /** Returns a description. */
  public String words() {
    return words;
  }

  public boolean motorsOn() {
    return motorsOn;
  }

  /** Whether the drone or its propellers move. */
  public boolean moving() {
    return motorsOn || this == FALLING;
  }

  /** Whether the drone is taking off, flying or landing. */
  public boolean flying() {
    return flying;
  }
}
