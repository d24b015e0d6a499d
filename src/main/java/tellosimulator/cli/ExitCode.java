package tellosimulator.cli;

/**
 * The exit codes of the program. Unrecoverable errors use {@link
 * tellosimulator.concurrent.FatalExit#CODE}.
 */
public final class ExitCode {

  public static final int DONE = 0;

  /** A resource could not be opened, read or written. */
  public static final int FAILED = 1;

  /** The options or a scenario are invalid. */
  public static final int WRONG_OPTIONS = 2;

  public static final int GOALS_MISSED = 3;

  /** The two compared flights differ. */
  public static final int FLIGHTS_DIFFER = 4;

  private ExitCode() {}
}
