package tellosimulator.sim;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.time.SimTime;
import tellosimulator.world.Collidable.OtherDrone;
import tellosimulator.world.Collider;
import tellosimulator.world.Collision;

/**
 * Resolves collisions between drones. All drones have the same mass, collisions are inelastic, and
 * a standing drone does not move. Confined to the simulation thread.
 */
final class DroneCollisions {

  private static final Collider COLLIDER = DroneSpec.COLLIDER;

  /**
   * Distance beyond which two drones cannot touch within a step [m]: two radii, plus a margin that
   * allows for the fastest fall.
   */
  private static final double FAR = 2 * COLLIDER.radius() + 0.5;

  /**
   * Step width along the relative path of two drones [m]. Decided: a quarter of a drone's height.
   */
  private static final double STRETCH = 0.01;

  /**
   * Acceleration at which a drone slips off another one [m/s²]. Assumed: the covers are round and
   * smooth.
   */
  private static final double SLIP = 4;

  private DroneCollisions() {}

  /** Separates all overlapping pairs, in the order of the drones' numbers. */
  static void resolve(List<SimDrone> drones) {
    int count = drones.size();
    if (count < 2) {
      return;
    }
    double[] x = new double[count];
    double[] y = new double[count];
    double[] z = new double[count];
    for (int i = 0; i < count; i++) {
      Vec3 position = drones.get(i).body().position();
      x[i] = position.x();
      y[i] = position.y();
      z[i] = position.z();
    }
    for (int i = 0; i < count; i++) {
      for (int j = i + 1; j < count; j++) {
        if (Math.abs(x[i] - x[j]) < FAR
            && Math.abs(y[i] - y[j]) < FAR
            && Math.abs(z[i] - z[j]) < FAR) {
          resolve(drones.get(i).body(), drones.get(j).body());
        }
      }
    }
  }

  private static void resolve(DroneBody one, DroneBody other) {
    if (one.resting() && other.resting()) {
      return;
    }
    Vec3 before = one.before().minus(other.before());
    Vec3 way = one.position().minus(other.position()).minus(before);
    int count = Math.max(1, (int) Math.ceil(way.norm() / STRETCH));
    for (int i = 1; i <= count; i++) {
      Optional<Vec3> push = push(before.plusScaled(way, (double) i / count), before);
      if (push.isPresent()) {
        Vec3 passed = before.plus(way).minus(before.plusScaled(way, (double) i / count));
        part(one, other, push.get(), passed);
        return;
      }
    }
  }

  /**
   * Returns the shortest displacement of a drone out of the other one; empty if the two do not
   * overlap.
   *
   * @param offset the drone's position relative to the other drone
   * @param before the offset at the beginning of the step
   */
  private static Optional<Vec3> push(Vec3 offset, Vec3 before) {
    double apart = offset.horizontal().norm();
    double sidewards = 2 * COLLIDER.radius() - apart;
    double upwards = COLLIDER.height() - Math.abs(offset.z());
    if (sidewards <= 0 || upwards <= 0) {
      return Optional.empty();
    }
    boolean wasBeside = before.horizontal().norm() >= 2 * COLLIDER.radius();
    boolean wasOver = Math.abs(before.z()) >= COLLIDER.height();
    boolean vertical = !wasBeside && (wasOver || upwards < sidewards);
    if (vertical) {
      return Optional.of(Vec3.UP.times(offset.z() < 0 ? -upwards : upwards));
    }
    return Optional.of(aside(offset).times(sidewards));
  }

  /** Returns the horizontal direction away from the other drone. */
  private static Vec3 aside(Vec3 offset) {
    Vec3 level = offset.horizontal();
    return level.equals(Vec3.ZERO) ? new Vec3(1, 0, 0) : level.normalized();
  }

  /**
   * Separates two drones.
   *
   * @param push the displacement that separates the drones, directed from {@code other} to {@code
   *     one}
   * @param passed the relative path of the drones after the contact; its component along the push
   *     is undone
   */
  private static void part(DroneBody one, DroneBody other, Vec3 push, Vec3 passed) {
    Vec3 normal = push.normalized();
    double closing = Math.max(0, -one.velocity().minus(other.velocity()).dot(normal));
    double back = push.norm() + Math.max(0, -passed.dot(normal));
    double share = one.resting() ? 0 : other.resting() ? 1 : 0.5;
    push(one, other, normal, new Share(share * back, share * closing, closing));
    push(
        other,
        one,
        normal.times(-1),
        new Share((1 - share) * back, (1 - share) * closing, closing));
  }

  /**
   * The share of one drone in a separation.
   *
   * @param way the drone's displacement [m]
   * @param stop the drone's loss of velocity [m/s]
   * @param closing the closing speed of the pair [m/s]
   */
  private record Share(double way, double stop, double closing) {}

  private static void push(DroneBody drone, DroneBody other, Vec3 normal, Share share) {
    if (drone.resting()) {
      return;
    }
    Vec3 slip =
        normal.z() > 0
            ? aside(drone.position().minus(other.position())).times(SLIP * SimTime.STEP)
            : Vec3.ZERO;
    drone.stopBy(
        new Collision(
            new OtherDrone(other.number()),
            normal,
            share.closing,
            drone.position().plusScaled(normal, share.way),
            drone.velocity().plusScaled(normal, share.stop).plus(slip)));
  }
}
