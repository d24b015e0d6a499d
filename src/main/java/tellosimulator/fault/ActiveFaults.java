package tellosimulator.fault;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The faults that are active on a drone at one moment. Immutable; for any thread.
 *
 * @param link how good it is otherwise
 * @param faults that act, in the order in which they began
 */
public record ActiveFaults(LinkPreset link, List<Fault> faults) {

  /** Nothing. */
  public static final ActiveFaults NONE = new ActiveFaults(LinkPreset.IDEAL, List.of());

  public ActiveFaults {
    faults = List.copyOf(faults);
  }

  /** The fault of a kind that began last. */
  public Optional<Fault> find(FaultKind kind) {
    if (faults.isEmpty()) {
      return Optional.empty();
    }
    Optional<Fault> found = Optional.empty();
    for (Fault fault : faults) {
      if (fault.kind() == kind) {
        found = Optional.of(fault);
      }
    }
    return found;
  }

  /**
   * What acts on one way over the link, by kind. A fault stands in for one of the same kind that
   * began before it, or that belongs to the preset.
   */
  Map<FaultKind, Fault> on(LinkDirection direction) {
    Map<FaultKind, Fault> acting = new EnumMap<>(FaultKind.class);
    for (Fault fault : link.faults()) {
      if (fault.concerns(direction)) {
        acting.put(fault.kind().onLink(), fault);
      }
    }
    for (Fault fault : faults) {
      if (fault.concerns(direction)) {
        acting.put(fault.kind().onLink(), fault);
      }
    }
    return acting;
  }
}
