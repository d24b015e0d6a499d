package tellosimulator.model;

/** The directions in which a drone detects mission pads. */
public enum PadMode {
  OFF,
  DOWN,
  FORWARD,
  BOTH
}
