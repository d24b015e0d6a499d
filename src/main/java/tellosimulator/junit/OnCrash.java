package tellosimulator.junit;

/**
 * Determines whether a test fails if it passes its own assertions, but a drone crashed or the goals
 * were missed.
 */
public enum OnCrash {

  /** The test fails. */
  FAIL,

  /** The test passes: only its own assertions count. */
  ALLOW
}
