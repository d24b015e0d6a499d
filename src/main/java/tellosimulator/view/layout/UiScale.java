package tellosimulator.view.layout;

import java.util.OptionalDouble;

/** The scale of everything in the window. JavaFX reads it only at startup. */
enum UiScale {
  /** The system's scale. */
  SYSTEM(OptionalDouble.empty()),
  PERCENT_100(OptionalDouble.of(1)),
  PERCENT_125(OptionalDouble.of(1.25)),
  PERCENT_150(OptionalDouble.of(1.5)),
  PERCENT_200(OptionalDouble.of(2)),
  PERCENT_300(OptionalDouble.of(3));

  /** Screen pixels per window pixel; empty for the system's scale. */
  private final OptionalDouble factor;

  UiScale(OptionalDouble factor) {
    this.factor = factor;
  }

  /**
   * Sets the scale for JavaFX. Must be called before JavaFX starts. On macOS, only the system's
   * scale applies.
   */
  void apply() {
    factor.ifPresent(
        value -> {
          System.setProperty("glass.gtk.uiScale", Double.toString(value));
          System.setProperty("glass.win.uiScale", Double.toString(value));
        });
  }
}
