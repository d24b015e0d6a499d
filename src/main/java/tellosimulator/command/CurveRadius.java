package tellosimulator.command;

import java.util.Optional;
import tellosimulator.math.Arc;
import tellosimulator.words.Phrase;

/** Which circles a drone flies. */
public final class CurveRadius {

  /** Smallest radius of a curve [m]. Report. */
  private static final double SMALLEST = 0.5;

  /** Largest radius of a curve [m]. Report. */
  private static final double LARGEST = 10;

  private CurveRadius() {}

  /**
   * Why a drone does not fly a curve, which it answers with {@link Reply#RADIUS}; empty if it does.
   *
   * @param arc metres; empty if the three points lie on one line
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
                "the radius is %.2f m, allowed is %.1f to %.0f m", radius, SMALLEST, LARGEST));
  }
}
