package tellosimulator.scenery.overlay;

/** The visual emphasis of a drone's path, plumb line, ring and tag. */
enum Emphasis {

  /** A lone drone, or one of several drones while none is selected. */
  NORMAL,

  /** The selected drone among several. */
  STRONG,

  /** All other drones while one is selected. */
  FAINT;

  /**
   * Opacity of a faint line, relative to a normal one. Decided: the paths of 20 drones are still
   * visible.
   */
  private static final double FAINT_OPACITY = 0.35;

  /** Returns the opacity of a line relative to a normal one, 0 to 1. */
  double opacity() {
    return this == FAINT ? FAINT_OPACITY : 1;
  }
}
