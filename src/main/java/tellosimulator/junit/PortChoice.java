package tellosimulator.junit;

/** Which ports a simulator and the program under test use. */
public enum PortChoice {

  /** Free ones, other ones for each simulator, so that tests may run beside each other. */
  FREE,

  /**
   * Those of the real drone, for programs that cannot be told a port: 8889 on 127.0.0.1 (further
   * drones on 127.0.0.2 and so on), 8890 and 11111. Only one simulator of the machine has them at a
   * time; others wait for it.
   */
  REAL
}
