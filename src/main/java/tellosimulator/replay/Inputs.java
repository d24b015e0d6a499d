package tellosimulator.replay;

import java.io.IOException;
import java.util.Optional;
import tellosimulator.recording.RecordedInputs;
import tellosimulator.recording.RecordedInputs.RecordedInput;
import tellosimulator.sim.SimListener;
import tellosimulator.time.SimTime;

/** The inputs of a simulation that replays a flight. Not thread-safe. */
interface Inputs extends SimListener {

  /**
   * Returns the next input that is due.
   *
   * @param now the end of the last step
   * @return the input; empty if none is due before the next step
   * @throws IOException if the inputs cannot be read
   */
  Optional<RecordedInput> due(SimTime now) throws IOException;

  /** Returns whether the flight continues after {@code now}. */
  boolean goesOn(SimTime now);

  /**
   * All inputs of a recorded simulation. Each is applied after the same step as in the recording.
   */
  final class Exact implements Inputs {

    private final RecordedInputs recorded;
    private final SimTime end;
    private Optional<RecordedInput> next;

    /**
     * Creates the inputs, and reads the first one.
     *
     * @throws IOException if the inputs cannot be read
     */
    Exact(RecordedInputs recorded, SimTime end) throws IOException {
      this.recorded = recorded;
      this.end = end;
      next = recorded.next();
    }

    @Override
    public Optional<RecordedInput> due(SimTime now) throws IOException {
      if (next.isEmpty() || now.isBefore(next.get().time())) {
        return Optional.empty();
      }
      Optional<RecordedInput> due = next;
      next = recorded.next();
      return due;
    }

    @Override
    public boolean goesOn(SimTime now) {
      return now.isBefore(end);
    }
  }
}
