package tellosimulator.board;

/**
 * What the lamp does. Immutable.
 *
 * @param mode how it changes
 * @param hertz how often in a second; 0 if it does not
 * @param first its colour, as one writes #rrggbb
 * @param second the colour with which it takes turns
 */
public record LampEffect(Mode mode, double hertz, int first, int second) {

  /** How the lamp changes. */
  public enum Mode {
    STEADY,
    /** From dark to its colour and back. */
    BREATHE,
    /** Between two colours. */
    BLINK
  }

  /** Without light. */
  public static final LampEffect DARK = steady(0);

  /** Steps of brightness while it breathes. Decided: no step can be seen. */
  private static final int STEPS = 32;

  public static LampEffect steady(int rgb) {
    return new LampEffect(Mode.STEADY, 0, rgb, rgb);
  }

  public static LampEffect breathing(double hertz, int rgb) {
    return new LampEffect(Mode.BREATHE, hertz, rgb, 0);
  }

  public static LampEffect blinking(double hertz, int first, int second) {
    return new LampEffect(Mode.BLINK, hertz, first, second);
  }

  /** Whether it changes by itself. */
  boolean animated() {
    return mode != Mode.STEADY;
  }

  /**
   * Its colour, as one writes #rrggbb.
   *
   * @param seconds since it began
   */
  int rgb(double seconds) {
    double part = seconds * hertz - Math.floor(seconds * hertz);
    return switch (mode) {
      case STEADY -> first;
      case BREATHE -> shaded(Math.rint(STEPS * (1 - Math.abs(1 - 2 * part))) / STEPS);
      case BLINK -> part < 0.5 ? first : second;
    };
  }

  private int shaded(double factor) {
    int red = (int) Math.round((first >> 16 & 0xff) * factor);
    int green = (int) Math.round((first >> 8 & 0xff) * factor);
    int blue = (int) Math.round((first & 0xff) * factor);
    return red << 16 | green << 8 | blue;
  }
}
