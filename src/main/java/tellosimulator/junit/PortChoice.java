package tellosimulator.junit;

/** The ports that a simulator and the program under test use. */
public enum PortChoice {

  /** Free ports, different for each simulator, so that tests can run in parallel. */
  FREE,

  /**
   * The ports of the real drone, for programs whose ports cannot be configured: 8889 on 127.0.0.1
   * (further drones on 127.0.0.2 and so on), 8890 and 11111. Only one simulator on the machine can
   * hold these ports at a time; others wait until they are free.
   */
  REAL
}
