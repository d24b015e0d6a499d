package tellosimulator.view.layout;

import java.util.OptionalDouble;

/** How large everything in the window is drawn. JavaFX takes it only when it starts. */
enum UiScale {
  /** As the system says. */
  SYSTEM(OptionalDouble.empty()),
  PERCENT_100(OptionalDouble.of(1)),
  PERCENT_125(OptionalDouble.of(1.25)),
  PERCENT_150(OptionalDouble.of(1.5)),
  PERCENT_200(OptionalDouble.of(2)),
  PERCENT_300(OptionalDouble.of(3));

  /** Pixels of the screen for a pixel of the window; empty for what the system says. */
  private final OptionalDouble factor;

  UiScale(OptionalDouble factor) {
    this.factor = factor;
  }

  /**
   * Lets JavaFX start with this scale; to be called before it starts. On macOS the system alone
   * decides.
   */
  void apply() {
    factor.ifPresent(
        value -> {
          System.setProperty("glass.gtk.uiScale", Double.toString(value));
          System.setProperty("glass.win.uiScale", Double.toString(value));
        });
  }
}
