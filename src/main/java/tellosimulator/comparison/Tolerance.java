package tellosimulator.comparison;

import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import tellosimulator.comparison.FlownCommand.Motion;

/**
 * How much two flights of the same commands may differ and still count as alike. Immutable; for any
 * thread.
 *
 * @param share of the larger value, for durations and distances, 0 to 1
 * @param seconds a duration may differ by so much in any case [s]
 * @param centimeters a distance may differ by so much in any case [cm]
 * @param degrees a turn may differ by so much
 */
public record Tolerance(double share, double seconds, double centimeters, double degrees) {

  /**
   * What a real drone differs by from flight to flight. Decided: 15 % is the scatter of the
   * published durations; state lines tell speeds in steps of 10 cm/s.
   */
  public static final Tolerance DEFAULT = new Tolerance(0.15, 0.5, 30, 10);

  /** In what a command of two flights can differ. */
  public enum Aspect {
    /** It was sent in one of them only. */
    MISSING,
    REPLY,
    DURATION,
    DISTANCE,
    HEIGHT,
    TURN
  }

  /** In what a command of two flights differs. */
  Set<Aspect> differing(FlownCommand first, FlownCommand second) {
    Set<Aspect> differing = EnumSet.noneOf(Aspect.class);
    boolean read = first.command().text().endsWith("?");
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
