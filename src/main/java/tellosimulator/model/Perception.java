package tellosimulator.model;

import java.util.List;

/**
 * A drone's perception of mission pads. Immutable.
 *
 * @param padMode the directions of detection
 * @param looked whether detection has already run at least once in these directions
 * @param pads the pads in sight; the first of them is reported
 */
public record Perception(PadMode padMode, boolean looked, List<PadSighting> pads) {

  /** The perception while detection is off. */
  public static final Perception OFF = new Perception(PadMode.OFF, false, List.of());

  public Perception {
    pads = List.copyOf(pads);
  }

  /** Returns the mission pad fields of the state line. */
  public PadReading reading() {
    if (padMode == PadMode.OFF) {
      return PadReading.OFF;
    }
    return pads.isEmpty() ? PadReading.NONE : pads.get(0).reading();
  }
}
