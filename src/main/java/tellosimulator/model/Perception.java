package tellosimulator.model;

import java.util.List;

/**
 * What a drone sees of mission pads. Immutable; for any thread.
 *
 * @param padMode where it looks for them
 * @param looked whether it has looked there yet
 * @param pads those that it sees, the one first that it reports
 */
public record Perception(PadMode padMode, boolean looked, List<PadSighting> pads) {

  /** It does not look. */
  public static final Perception OFF = new Perception(PadMode.OFF, false, List.of());

  public Perception {
    pads = List.copyOf(pads);
  }

  /** What the state line says of them. */
  public PadReading reading() {
    if (padMode == PadMode.OFF) {
      return PadReading.OFF;
    }
    return pads.isEmpty() ? PadReading.NONE : pads.get(0).reading();
  }
}
