package tellosimulator.command;

import java.util.Optional;
import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.words.Phrase;

/** What must hold of the points of {@code go} and {@code curve} taken together. */
public final class GeometryRules {

  /** For people: what {@link #go} checks. */
  static final String CUBE = "no point within ±20 cm in x, y and z";

  /** Half the edge of the cube in which a goal is too near [m], its faces included. Report. */
  private static final double TOO_NEAR = 0.20;

  /** Smallest radius of a curve [m]. Report. */
  private static final double SMALLEST_RADIUS = 0.5;

  /** Largest radius of a curve [m]. Report. */
  private static final double LARGEST_RADIUS = 10;

  private GeometryRules() {}

  static Optional<Refusal> go(Arguments arguments) {
    return tooNear("", arguments.point(0));
  }

  static Optional<Refusal> curve(Arguments arguments) {
    return tooNear("1", arguments.point(0))
        .or(() -> tooNear("2", arguments.point(3)))
        .or(() -> radius(Arc.through(arguments.point(0), arguments.point(3))));
  }

  /** Documented: SDK 3.0 guide, z from 0 over a pad; SDK 2.0 guide, also below. */
  static Optional<Refusal> goToPad(Arguments arguments, Profile profile) {
    return go(arguments).or(() -> belowPad("z", arguments.number(2), profile));
  }

  /** The radius depends on where the pad is seen, so it is not known yet. */
  static Optional<Refusal> curveOverPad(Arguments arguments, Profile profile) {
    return tooNear("1", arguments.point(0))
        .or(() -> tooNear("2", arguments.point(3)))
        .or(() -> belowPad("z1", arguments.number(2), profile))
        .or(() -> belowPad("z2", arguments.number(5), profile));
  }

  /** Documented: SDK 3.0 guide, z above 0. */
  static Optional<Refusal> jump(Arguments arguments, Profile profile) {
    return profile.knows(Sdk.SDK_3_0) && arguments.number(2) == 0
        ? Optional.of(new Refusal(Reply.OUT_OF_RANGE, Phrase.of("z is 0, it must be above 0")))
        : belowPad("z", arguments.number(2), profile);
  }

  /** The arc of a curve whose points have passed {@link #curve}. */
  static Arc arc(Arguments arguments) {
    return Arc.through(arguments.point(0), arguments.point(3)).orElseThrow();
  }

  /**
   * @param index what the names of the coordinates end with
   */
  private static Optional<Refusal> tooNear(String index, Vec3 point) {
    boolean near =
        Math.abs(point.x()) <= TOO_NEAR
            && Math.abs(point.y()) <= TOO_NEAR
            && Math.abs(point.z()) <= TOO_NEAR;
    return near
        ? Optional.of(
            new Refusal(
                Reply.OUT_OF_RANGE,
                Phrase.of(
                    "x%1$s, y%1$s and z%1$s are all within ±20 cm, one of them must be further away",
                    index)))
        : Optional.empty();
  }

  private static Optional<Refusal> belowPad(String name, double z, Profile profile) {
    return profile.knows(Sdk.SDK_3_0) && z < 0
        ? Optional.of(
            new Refusal(
                Reply.OUT_OF_RANGE, Phrase.of("%s is below the pad, allowed is from 0", name)))
        : Optional.empty();
  }

  /**
   * Why a drone does not fly a curve, which it answers with {@link Reply#RADIUS}; empty if it does.
   *
   * @param arc metres; empty if the three points lie on one line
   */
  public static Optional<Phrase> radiusObjection(Optional<Arc> arc) {
    if (arc.isEmpty()) {
      return Optional.of(Phrase.of("the three points lie on one line, no circle passes them"));
    }
    double radius = arc.get().radius();
    return radius >= SMALLEST_RADIUS && radius <= LARGEST_RADIUS
        ? Optional.empty()
        : Optional.of(
            Phrase.of(
                "the radius is %.2f m, allowed is %.1f to %.0f m",
                radius, SMALLEST_RADIUS, LARGEST_RADIUS));
  }

  private static Optional<Refusal> radius(Optional<Arc> arc) {
    return radiusObjection(arc).map(reason -> new Refusal(Reply.RADIUS, reason));
  }
}
