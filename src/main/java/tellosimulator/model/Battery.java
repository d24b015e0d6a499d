package tellosimulator.model;

/**
 * A battery's charge. Immutable.
 *
 * @param level 0 for empty to 1 for full
 */
public record Battery(double level) {

  /** A flip needs at least this much [%]. Measured: DJITelloPy issue 224. */
  public static final int LEAST_FOR_FLIP = 50;

  /** A takeoff needs more than this [%]. Assumed. */
  public static final int TOO_LOW_FOR_TAKEOFF = 10;

  /** In flight it lands by itself at this, and below [%]. Assumed. */
  public static final int LANDS_BY_ITSELF = 5;

  public static final Battery FULL = new Battery(1);

  public Battery {
    if (!(level >= 0 && level <= 1)) {
      throw new IllegalArgumentException("battery level is " + level + ", but must be 0 to 1");
    }
  }

  /** What the drone reports: started percents count as whole ones. */
  public int percent() {
    return (int) Math.ceil(level * 100 - 1e-9);
  }

  public boolean empty() {
    return level == 0;
  }

  /** The charge after some time. */
  Battery after(double seconds, double endurance) {
    return new Battery(Math.max(0, level - seconds / endurance));
  }
}
