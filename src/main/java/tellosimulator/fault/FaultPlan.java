package tellosimulator.fault;

import java.util.List;
import java.util.Optional;

/**
 * The faults that are planned before a simulation starts, and the quality of the link. Immutable.
 *
 * @param link the quality of the link; empty for the default of each drone's behaviour
 */
public record FaultPlan(Optional<LinkPreset> link, List<Fault> faults) {

  /** A plan without faults and with the default link quality. */
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
