package tellosimulator.scenery;

/** How light and depth act on a part. */
public enum Finish {
  /** Looks as its picture does; light and shade are painted into it. */
  PAINTED,
  /** Lit by the {@link Lamps} of the room. */
  LIT,
  /** Painted on what lies under it, which it covers as far as its picture is not transparent. */
  DECAL,
  /**
   * Looks as its picture does and lets through what is behind it, as far as its picture is
   * transparent. What stands in front hides it; it hides nothing, and its faces may be seen through
   * each other.
   */
  SHEER
}
