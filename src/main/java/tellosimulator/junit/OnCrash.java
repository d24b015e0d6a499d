package tellosimulator.junit;

/** What becomes of a test whose drone crashed, or missed its goals, though nobody asserted it. */
public enum OnCrash {

  /** It fails. */
  FAIL,

  /** Nothing: the test judges by itself. */
  ALLOW
}
