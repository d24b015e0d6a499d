package tellosimulator.world;

import java.util.Optional;
import tellosimulator.math.Vec3;

/**
 * An upright cylinder.
 *
 * @param middle of its base, room frame [m]
 */
record Pillar(Vec3 middle, double radius, double height) implements Solid {

  @Override
  public Bounds bounds() {
    return new Bounds(
        middle.minus(new Vec3(radius, radius, 0)), middle.plus(new Vec3(radius, radius, height)));
  }

  @Override
  public Optional<Exit> exit(Vec3 position, Vec3 before, Hull hull) {
    boolean wasBeside = sidewards(before, hull.radius()).depth() <= 0;
    return upright().exit(position, before, hull, sidewards(position, hull.radius()), wasBeside);
  }

  private Exit sidewards(Vec3 position, double grown) {
    Vec3 spoke = position.minus(middle).horizontal();
    double distance = spoke.norm();
    Vec3 normal = distance == 0 ? new Vec3(1, 0, 0) : spoke.times(1 / distance);
    return new Exit(normal, radius + grown - distance);
  }

  @Override
  public double distance(Vec3 origin, Vec3 direction) {
    double[] z = upright().between(origin, direction);
    Vec3 from = origin.minus(middle).horizontal();
    Vec3 along = direction.horizontal();
    double a = along.dot(along);
    double c = from.dot(from) - radius * radius;
    if (a == 0) {
      return c <= 0 ? Upright.entry(z[0], z[1]) : Double.POSITIVE_INFINITY;
    }
    double b = from.dot(along);
    double root = b * b - a * c;
    if (root < 0) {
      return Double.POSITIVE_INFINITY;
    }
    double half = Math.sqrt(root);
    return Upright.entry(Math.max(z[0], (-b - half) / a), Math.min(z[1], (-b + half) / a));
  }

  private Upright upright() {
    return new Upright(middle.z(), middle.z() + height);
  }
}
