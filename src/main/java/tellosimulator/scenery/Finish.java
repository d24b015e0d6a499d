package tellosimulator.scenery;

/** How light and depth act on a part. */
public enum Finish {
  /** Looks as its picture does; light and shade are painted into it. */
  PAINTED,
  /** Lit by the lamps of the room. */
  LIT,
  /** Painted on what lies under it, which it covers as far as its picture is not transparent. */
  DECAL
}
