package tellosimulator.cli;

/**
 * The exit codes of the program. Unrecoverable errors use {@link
 * tellosimulator.concurrent.FatalExit#CODE}. For any thread.
 */
public final class ExitCode {

  public static final int DONE = 0;

  /** Something could not be had, read or written. */
  public static final int FAILED = 1;

  /** Options or a scenario are wrong. */
  public static final int WRONG_OPTIONS = 2;

  public static final int GOALS_MISSED = 3;

  /** Two flights that are compared are not alike. */
  public static final int FLIGHTS_DIFFER = 4;

  private ExitCode() {}
}
