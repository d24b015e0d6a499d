package tellosimulator.grade;

/** A listener that is notified of the progress of grading, on several threads. */
public interface GradingListener {

  /** Called once, before the first flight. */
  void begins(int flights);

  /**
   * Called after a flight.
   *
   * @param handIn the name of the hand-in
   * @param kept whether it was flown earlier
   */
  void graded(String handIn, GradedFlight flight, boolean kept);
}
