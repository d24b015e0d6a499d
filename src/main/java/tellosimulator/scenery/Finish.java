package tellosimulator.scenery;

import java.util.Optional;

/** How light and depth act on a part. */
public enum Finish {
  /** Looks as its picture does; light and shade are painted into it. */
  PAINTED,
  /** Lit as drones are: {@link Lamps#ON_DRONES}. */
  LIT(Lamps.ON_DRONES),
  /** Lit as what stands in the room: {@link Lamps#ON_FURNITURE}. */
  MATT(Lamps.ON_FURNITURE),
  /** Painted on what lies under it, which it covers as far as its picture is not transparent. */
  DECAL,
  /**
   * Looks as its picture does and lets through what is behind it, as far as its picture is
   * transparent. What stands in front hides it; it hides nothing, and its faces may be seen through
   * each other.
   */
  SHEER;

  private final Optional<Lamps> lamps;

  Finish() {
    lamps = Optional.empty();
  }

  Finish(Lamps lamps) {
    this.lamps = Optional.of(lamps);
  }

  /** The light that falls on it; empty if it needs none. */
  public Optional<Lamps> lamps() {
    return lamps;
  }
}
