package tellosimulator.scenery.overlay;

/** How much the path, the plumb line, the ring and the tag of a drone stand out. */
enum Emphasis {

  /** Of a drone alone, or of several of which none is chosen. */
  NORMAL,

  /** Of the chosen one of several drones. */
  STRONG,

  /** Of the others beside a chosen one. */
  FAINT;

  /**
   * Opacity of a faint line by that of a normal one. Decided: paths of 20 drones can still be seen.
   */
  private static final double FAINT_OPACITY = 0.35;

  /** Opacity of a line by that of a normal one, 0 to 1. */
  double opacity() {
    return this == FAINT ? FAINT_OPACITY : 1;
  }
}
