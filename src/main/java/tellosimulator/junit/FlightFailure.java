package tellosimulator.junit;

/** Something did not come about; the message tells what happened instead. */
final class FlightFailure extends AssertionError {

  private static final long serialVersionUID = 1;

  /**
   * @param what did not come about
   * @param explanation see {@link TelloSimulator#explanation}
   */
  FlightFailure(String what, String explanation) {
    super(what + System.lineSeparator() + explanation);
  }
}
