package tellosimulator.fault;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The faults that are active on a drone at one moment. Immutable.
 *
 * @param link the basic link quality, to which the faults are added
 * @param faults the active faults, in the order in which they began
 */
public record ActiveFaults(LinkPreset link, List<Fault> faults) {

  /** An ideal link without faults. */
  public static final ActiveFaults NONE = new ActiveFaults(LinkPreset.IDEAL, List.of());

  public ActiveFaults {
    faults = List.copyOf(faults);
  }

  /** Returns the most recent active fault of a kind, if any. */
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
   * Returns the faults that are active in one direction of the link, by kind. A fault replaces any
   * earlier fault of the same kind, including one that belongs to the preset.
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
