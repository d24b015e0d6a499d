package tellosimulator.command;

import java.util.Optional;
import tellosimulator.controller.CurveRadius;
import tellosimulator.math.Arc;
import tellosimulator.math.Vec3;
import tellosimulator.profile.Profile;
import tellosimulator.profile.Sdk;
import tellosimulator.words.Phrase;

/**
 * The rules for the points of {@code go}, {@code curve} and {@code jump}, in addition to the ranges
 * of the single coordinates.
 */
final class GeometryRules {

  /** Describes the rule that {@link #go} checks. */
  static final String CUBE = "no point within ±20 cm in x, y and z";

  /**
   * Half the edge length of a cube around the drone or pad [m]. The drone refuses points inside the
   * cube and on its faces. Report.
   */
  private static final double TOO_NEAR = 0.20;

  private GeometryRules() {}

  static Optional<Refusal> go(Arguments arguments) {
    return tooNear("", arguments.point(0));
  }

  static Optional<Refusal> curve(Arguments arguments) {
    return tooNear("1", arguments.point(0))
        .or(() -> tooNear("2", arguments.point(3)))
        .or(() -> radius(Arc.through(arguments.point(0), arguments.point(3))));
  }

  /**
   * Checks the goal over a pad. Documented: z must be at least 0 in SDK 3.0, and may be negative in
   * SDK 2.0 (User Guides).
   */
  static Optional<Refusal> goToPad(Arguments arguments, Profile profile) {
    return go(arguments).or(() -> belowPad("z", arguments.number(2), profile));
  }

  /**
   * Checks the points over a pad, but not the radius. The radius depends on the drone's position
   * relative to the pad. This position is not known yet.
   */
  static Optional<Refusal> curveOverPad(Arguments arguments, Profile profile) {
    return tooNear("1", arguments.point(0))
        .or(() -> tooNear("2", arguments.point(3)))
        .or(() -> belowPad("z1", arguments.number(2), profile))
        .or(() -> belowPad("z2", arguments.number(5), profile));
  }

  /** Checks the goal of a jump. Documented: z must be above 0 (SDK 3.0 guide). */
  static Optional<Refusal> jump(Arguments arguments, Profile profile) {
    return profile.knows(Sdk.SDK_3_0) && arguments.number(2) == 0
        ? Optional.of(new Refusal(Reply.OUT_OF_RANGE, Phrase.of("z is 0, it must be above 0")))
        : belowPad("z", arguments.number(2), profile);
  }

  /** Returns the arc of a curve whose points have passed {@link #curve}. */
  static Arc arc(Arguments arguments) {
    return Arc.through(arguments.point(0), arguments.point(3)).orElseThrow();
  }

  /**
   * Refuses a point in the cube of {@link #TOO_NEAR}.
   *
   * @param index the suffix of the coordinates' names, such as 1 in x1; empty if there is none
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
                Reply.OUT_OF_RANGE, Phrase.of("%s is below the pad, but must be at least 0", name)))
        : Optional.empty();
  }

  private static Optional<Refusal> radius(Optional<Arc> arc) {
    return CurveRadius.objection(arc).map(reason -> new Refusal(Reply.RADIUS, reason));
  }
}
