package tellosimulator.math;

import java.util.Optional;

/**
 * A circular arc that starts at the origin, passes through one point and ends at another.
 *
 * @param center the centre of the circle, in the frame and the unit of the points
 * @param radius the radius of the circle
 * @param outward the unit vector from the centre to the origin
 * @param along the unit tangent at the origin, in the direction in which the arc leaves it
 * @param angle the central angle of the arc [rad], less than a full turn
 */
public record Arc(Vec3 center, double radius, Vec3 outward, Vec3 along, double angle) {

  /**
   * Threshold for collinear points. Two points are on one line with the origin if the length of
   * their cross product is at most this fraction of the product of their distances from the origin.
   */
  private static final double COLLINEAR = 1e-9;

  /**
   * Returns the arc from the origin through {@code via} to {@code end}; empty if the three points
   * lie on one line, so that no circle passes through them.
   */
  public static Optional<Arc> through(Vec3 via, Vec3 end) {
    Vec3 normal = via.cross(end);
    double twiceArea = normal.norm();
    double size = via.norm() * end.norm() * via.distanceTo(end);
    if (size == 0 || twiceArea <= COLLINEAR * via.norm() * end.norm()) {
      return Optional.empty();
    }
    double viaSquared = via.dot(via);
    double endSquared = end.dot(end);
    Vec3 center =
        end.times(viaSquared)
            .minus(via.times(endSquared))
            .cross(normal)
            .times(1 / (2 * twiceArea * twiceArea));
    double radius = center.norm();
    Vec3 outward = center.times(-1 / radius);
    Vec3 along = normal.times(1 / twiceArea).cross(outward);
    Arc start = new Arc(center, radius, outward, along, 0);
    return Optional.of(new Arc(center, radius, outward, along, start.angleOf(end)));
  }

  public double length() {
    return radius * angle;
  }

  /** Returns the point at the central angle {@code swept} [rad] from the origin. */
  public Vec3 point(double swept) {
    return center
        .plusScaled(outward, radius * StrictMath.cos(swept))
        .plusScaled(along, radius * StrictMath.sin(swept));
  }

  /**
   * Returns the unit vector of the direction of motion at the central angle {@code swept} [rad].
   */
  public Vec3 direction(double swept) {
    return along.times(StrictMath.cos(swept)).plusScaled(outward, -StrictMath.sin(swept));
  }

  /** Returns the unit vector from the point at {@code swept} [rad] to the centre. */
  public Vec3 inward(double swept) {
    return outward.times(-StrictMath.cos(swept)).plusScaled(along, -StrictMath.sin(swept));
  }

  private double angleOf(Vec3 point) {
    Vec3 spoke = point.minus(center);
    double swept = StrictMath.atan2(spoke.dot(along), spoke.dot(outward));
    return swept < 0 ? swept + 2 * Math.PI : swept;
  }
}
