package tellosimulator.extension;

/**
 * An effect of the lamp. Immutable.
 *
 * @param mode how the colour changes
 * @param hertz the frequency of the change [Hz]; 0 if the colour is steady
 * @param first the colour, as 0xrrggbb
 * @param second the colour with which {@code first} alternates, as 0xrrggbb; used only while
 *     blinking
 */
public record LampEffect(Mode mode, double hertz, int first, int second) {

  /** How the colour changes. */
  public enum Mode {
    STEADY,
    /** Fades from dark to the colour and back. */
    BREATHE,
    /** Alternates between two colours. */
    BLINK
  }

  /** An effect that keeps the lamp dark. */
  public static final LampEffect DARK = steady(0);

  /** Number of brightness steps while breathing. Decided: each step is too small to be visible. */
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

  /** Whether the lamp changes with time. */
  boolean animated() {
    return mode != Mode.STEADY;
  }

  /**
   * Returns the colour, as 0xrrggbb.
   *
   * @param seconds the time since the start of the effect
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
