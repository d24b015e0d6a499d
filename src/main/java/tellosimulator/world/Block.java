package tellosimulator.world;

import java.util.Optional;
import tellosimulator.math.Vec3;

/**
 * An upright box.
 *
 * @param middle of its base, room frame [m]
 * @param half half its depth (x), half its width (y) and its height (z) [m]
 * @param ahead unit vector of its x axis, level
 */
record Block(Vec3 middle, Vec3 half, Vec3 ahead) implements Solid {

  @Override
  public Bounds bounds() {
    double x = Math.abs(ahead.x()) * half.x() + Math.abs(ahead.y()) * half.y();
    double y = Math.abs(ahead.y()) * half.x() + Math.abs(ahead.x()) * half.y();
    return new Bounds(middle.minus(new Vec3(x, y, 0)), middle.plus(new Vec3(x, y, half.z())));
  }

  @Override
  public Optional<Exit> exit(Vec3 position, Vec3 before, Hull hull) {
    boolean wasBeside = sidewards(before, hull.radius()).depth() <= 0;
    return upright().exit(position, before, hull, sidewards(position, hull.radius()), wasBeside);
  }

  /** The shortest way to the side, out of the box grown by a radius. */
  private Exit sidewards(Vec3 position, double radius) {
    Vec3 local = local(position.minus(middle));
    double beyondX = Math.abs(local.x()) - half.x();
    double beyondY = Math.abs(local.y()) - half.y();
    double signX = local.x() < 0 ? -1 : 1;
    double signY = local.y() < 0 ? -1 : 1;
    if (beyondX > 0 && beyondY > 0) {
      double beyond = Math.sqrt(beyondX * beyondX + beyondY * beyondY);
      Vec3 corner = new Vec3(signX * beyondX / beyond, signY * beyondY / beyond, 0);
      return new Exit(room(corner), radius - beyond);
    }
    return beyondX > beyondY
        ? new Exit(room(new Vec3(signX, 0, 0)), radius - beyondX)
        : new Exit(room(new Vec3(0, signY, 0)), radius - beyondY);
  }

  @Override
  public double distance(Vec3 origin, Vec3 direction) {
    Vec3 from = local(origin.minus(middle));
    Vec3 along = local(direction);
    double[] z = upright().between(origin, direction);
    double[] x = slab(from.x(), along.x(), half.x());
    double[] y = slab(from.y(), along.y(), half.y());
    return Upright.entry(
        Math.max(z[0], Math.max(x[0], y[0])), Math.min(z[1], Math.min(x[1], y[1])));
  }

  private static double[] slab(double from, double along, double half) {
    return new Upright(-half, half).between(new Vec3(0, 0, from), new Vec3(0, 0, along));
  }

  private Upright upright() {
    return new Upright(middle.z(), middle.z() + half.z());
  }

  private Vec3 local(Vec3 vector) {
    return new Vec3(
        vector.x() * ahead.x() + vector.y() * ahead.y(),
        vector.y() * ahead.x() - vector.x() * ahead.y(),
        vector.z());
  }

  private Vec3 room(Vec3 vector) {
    return new Vec3(
        vector.x() * ahead.x() - vector.y() * ahead.y(),
        vector.x() * ahead.y() + vector.y() * ahead.x(),
        vector.z());
  }
}
