package tellosimulator.fault;

import java.util.List;
import java.util.Optional;

/**
 * What goes wrong in a simulation from its start on. Immutable.
 *
 * @param link how good it is; empty for that of each drone's behaviour
 */
public record FaultPlan(Optional<LinkPreset> link, List<Fault> faults) {

  /** Nothing is asked for. */
  public static final FaultPlan NONE = new FaultPlan(Optional.empty(), List.of());

  public FaultPlan {
    faults = List.copyOf(faults);
  }

  public FaultPlan withLink(LinkPreset newLink) {
    return new FaultPlan(Optional.of(newLink), faults);
  }

  public FaultPlan withFaults(List<Fault> newFaults) {
    return new FaultPlan(link, newFaults);
  }
}
