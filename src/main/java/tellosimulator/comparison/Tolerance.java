package tellosimulator.comparison;

import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import tellosimulator.command.WireText;
import tellosimulator.comparison.FlownCommand.Motion;

/**
 * The limits within which two flights with the same commands count as alike. Immutable.
 *
 * @param share the tolerated difference in durations and distances, as a fraction of the larger
 *     value, 0 to 1
 * @param seconds difference in duration that is always tolerated [s]
 * @param centimeters difference in distance that is always tolerated [cm]
 * @param degrees tolerated difference in turns [degrees]
 */
public record Tolerance(double share, double seconds, double centimeters, double degrees) {

  /**
   * The variation of a real drone from flight to flight. Decided: the published durations scatter
   * by 15 %, and state lines give speeds in steps of 10 cm/s.
   */
  public static final Tolerance DEFAULT = new Tolerance(0.15, 0.5, 30, 10);

  /** The aspects in which a command can differ between two flights. */
  public enum Aspect {
    /** The command was sent in only one of the flights. */
    MISSING,
    REPLY,
    DURATION,
    DISTANCE,
    HEIGHT,
    TURN
  }

  /** Returns the aspects in which a command differs between two flights. */
  Set<Aspect> differing(FlownCommand first, FlownCommand second) {
    Set<Aspect> differing = EnumSet.noneOf(Aspect.class);
    boolean read = WireText.isRead(first.command().words());
    if (first.command().answered().isPresent() != second.command().answered().isPresent()
        || (!read && !reply(first).equals(reply(second)))) {
      differing.add(Aspect.REPLY);
    }
    OptionalDouble longer = first.command().duration();
    OptionalDouble other = second.command().duration();
    if (longer.isPresent() && other.isPresent()) {
      add(differing, Aspect.DURATION, longer.getAsDouble(), other.getAsDouble(), seconds);
    }
    Optional<Motion> one = first.motion();
    Optional<Motion> two = second.motion();
    if (one.isPresent() && two.isPresent()) {
      addMotion(differing, one.get(), two.get());
    }
    return differing;
  }

  private void addMotion(Set<Aspect> differing, Motion first, Motion second) {
    double apart = Math.hypot(first.forward() - second.forward(), first.left() - second.left());
    double far =
        Math.max(
            Math.hypot(first.forward(), first.left()), Math.hypot(second.forward(), second.left()));
    if (apart > Math.max(centimeters, share * far)) {
      differing.add(Aspect.DISTANCE);
    }
    add(differing, Aspect.HEIGHT, first.up(), second.up(), centimeters);
    if (Math.abs(FlownCommand.wrapped(first.turn() - second.turn())) > degrees) {
      differing.add(Aspect.TURN);
    }
  }

  private void add(
      Set<Aspect> differing, Aspect aspect, double first, double second, double least) {
    double larger = Math.max(Math.abs(first), Math.abs(second));
    if (Math.abs(first - second) > Math.max(least, share * larger)) {
      differing.add(aspect);
    }
  }

  private static String reply(FlownCommand flown) {
    return flown.command().reply().stripTrailing();
  }
}
