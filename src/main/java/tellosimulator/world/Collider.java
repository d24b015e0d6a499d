package tellosimulator.world;

import tellosimulator.math.Vec3;

/**
 * The upright cylinder that represents a body in collisions. The middle of its base is at the
 * body's position.
 *
 * @param radius the radius [m]
 * @param height the height [m]
 */
public record Collider(double radius, double height) {

  /**
   * Returns the point of the body that is nearest to a given point. If the given point is inside
   * the body, returns the given point.
   *
   * @param foot the body's position
   */
  public Vec3 nearest(Vec3 foot, Vec3 point) {
    Vec3 aside = point.minus(foot).horizontal().limitedTo(radius);
    double height = Math.max(0, Math.min(this.height, point.z() - foot.z()));
    return foot.plus(aside.withZ(height));
  }

  /**
   * Returns the distance along a ray to the body [m]; infinite if the ray misses it.
   *
   * @param foot the body's position
   * @param direction a unit vector
   */
  public double distance(Vec3 foot, Vec3 origin, Vec3 direction) {
    return new UprightSolid.Cylinder(foot, radius, height).distance(origin, direction);
  }
}
