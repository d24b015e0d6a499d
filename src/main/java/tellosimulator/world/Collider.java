package tellosimulator.world;

import tellosimulator.math.Vec3;

/**
 * The upright cylinder that stands for a body in collisions, its foot at the body's position.
 *
 * @param radius metres
 * @param height metres
 */
public record Collider(double radius, double height) {

  /**
   * The point of the body that is nearest to another point; that point itself if it is inside.
   *
   * @param foot where the body is
   */
  public Vec3 nearest(Vec3 foot, Vec3 point) {
    Vec3 aside = point.minus(foot).horizontal().limitedTo(radius);
    double height = Math.max(0, Math.min(this.height, point.z() - foot.z()));
    return foot.plus(aside.withZ(height));
  }

  /**
   * Distance along a ray to the body [m]; infinite if the ray misses it.
   *
   * @param foot where the body is
   * @param direction unit vector
   */
  public double distance(Vec3 foot, Vec3 origin, Vec3 direction) {
    return new UprightSolid.Cylinder(foot, radius, height).distance(origin, direction);
  }
}
