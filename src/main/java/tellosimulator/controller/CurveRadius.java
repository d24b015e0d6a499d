package tellosimulator.controller;

import java.util.Optional;
import tellosimulator.math.Arc;
import tellosimulator.words.Phrase;

/** The range of radii for the curves that a drone can fly. */
public final class CurveRadius {

  /** Minimum radius of a curve [m]. Report. */
  private static final double SMALLEST = 0.5;

  /** Maximum radius of a curve [m]. Report. */
  private static final double LARGEST = 10;

  private CurveRadius() {}

  /**
   * Returns the reason why a drone cannot fly a curve; empty if it can.
   *
   * @param arc the curve [m]; empty if the three points lie on one line
   */
  public static Optional<Phrase> objection(Optional<Arc> arc) {
    if (arc.isEmpty()) {
      return Optional.of(Phrase.of("the three points lie on one line, no circle passes them"));
    }
    double radius = arc.get().radius();
    return radius >= SMALLEST && radius <= LARGEST
        ? Optional.empty()
        : Optional.of(
            Phrase.of(
                "the radius is %.2f m, but must be from %.1f to %.0f m",
                radius, SMALLEST, LARGEST));
  }
}
