package tellosimulator.model;

/** Where the drone looks for mission pads. */
public enum PadMode {
  OFF,
  DOWN,
  FORWARD,
  BOTH
}
