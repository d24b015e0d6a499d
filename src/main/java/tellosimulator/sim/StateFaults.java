package tellosimulator.sim;

import java.util.Optional;
import java.util.function.Supplier;
import tellosimulator.fault.ActiveFaults;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultKind;
import tellosimulator.fault.FaultParameter;
import tellosimulator.sim.StatePort.StateReport;
import tellosimulator.time.SimTime;

/** What faults make of a drone's state lines. For the simulation thread. */
final class StateFaults {

  private Optional<StateReport> last = Optional.empty();
  private SimTime sent = SimTime.ZERO;

  /**
   * The line that is sent when one is due, if any.
   *
   * @param right what it is without faults
   */
  Optional<StateReport> next(ActiveFaults faults, SimTime now, Supplier<StateReport> right) {
    if (faults.faults().isEmpty()) {
      last = Optional.of(right.get());
      sent = now;
      return last;
    }
    Optional<Fault> slow = faults.find(FaultKind.STATE_SLOW);
    boolean tooSoon =
        slow.filter(fault -> now.since(sent) < fault.value(FaultParameter.EVERY) - SimTime.STEP)
            .isPresent();
    if (tooSoon || faults.find(FaultKind.STATE_STOPPED).isPresent()) {
      return Optional.empty();
    }
    sent = now;
    boolean stuck = faults.find(FaultKind.STATE_STUCK).isPresent();
    last = stuck ? last.or(() -> Optional.of(right.get())) : Optional.of(right.get());
    return last;
  }
}
