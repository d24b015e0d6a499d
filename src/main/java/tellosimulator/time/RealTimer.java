package tellosimulator.time;

/** Measures real time from its creation. Immutable. */
public final class RealTimer {

  private final long begin = System.nanoTime();

  /** Returns the time since the creation [s of real time]. */
  public double seconds() {
    return (System.nanoTime() - begin) * 1e-9;
  }
}
