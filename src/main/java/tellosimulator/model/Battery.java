package tellosimulator.model;

/**
 * The charge of a battery. Immutable.
 *
 * @param level the charge, from 0 for empty to 1 for full
 */
public record Battery(double level) {

  /** Minimum charge for a flip [%]. Measured: DJITelloPy issue 224. */
  public static final int LEAST_FOR_FLIP = 50;

  /** Charge above which a drone can take off [%]. Assumed. */
  public static final int TOO_LOW_FOR_TAKEOFF = 10;

  /** Charge at or below which a drone in flight lands automatically [%]. Assumed. */
  public static final int LANDS_BY_ITSELF = 5;

  public static final Battery FULL = new Battery(1);

  public Battery {
    if (!(level >= 0 && level <= 1)) {
      throw new IllegalArgumentException("battery level is " + level + ", but must be 0 to 1");
    }
  }

  /** Returns the charge as the drone reports it, rounded up [%]. */
  public int percent() {
    return (int) Math.ceil(level * 100 - 1e-9);
  }

  public boolean empty() {
    return level == 0;
  }

  /**
   * Returns the battery after some time.
   *
   * @param seconds the time
   * @param endurance the time that a full battery lasts [s]
   */
  Battery after(double seconds, double endurance) {
    return new Battery(Math.max(0, level - seconds / endurance));
  }
}
