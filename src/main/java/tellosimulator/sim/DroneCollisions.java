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
 * Drones that run into each other. They are equally heavy and do not bounce; one that stands is not
 * moved. For the simulation thread.
 */
final class DroneCollisions {

  private static final Collider COLLIDER = DroneSpec.COLLIDER;

  /** Farther apart than this they cannot touch within a step [m]: their size and fastest fall. */
  private static final double FAR = 2 * COLLIDER.radius() + 0.5;

  /** Longest stretch of their way to each other [m]. Decided: a quarter of a drone's height. */
  private static final double STRETCH = 0.01;

  /** How fast one slips off another one's back [m/s²]. Assumed: round, smooth covers. */
  private static final double SLIP = 4;

  private DroneCollisions() {}

  /** Keeps all pairs apart, in the order of their numbers. */
  static void resolve(List<SimDrone> drones) {
    int count = drones.size();
    if (count < 2) {
      return;
    }
    double[] x = new double[count];
    double[] y = new double[count];
    double[] z = new double[count];
    for (int i = 0; i < count; i++) {
      Vec3 position = drones.get(i).position();
      x[i] = position.x();
      y[i] = position.y();
      z[i] = position.z();
    }
    for (int i = 0; i < count; i++) {
      for (int j = i + 1; j < count; j++) {
        if (Math.abs(x[i] - x[j]) < FAR
            && Math.abs(y[i] - y[j]) < FAR
            && Math.abs(z[i] - z[j]) < FAR) {
          resolve(drones.get(i), drones.get(j));
        }
      }
    }
  }

  private static void resolve(SimDrone one, SimDrone other) {
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
   * The way out of the other drone; empty if it is not in it.
   *
   * @param offset from the other one
   * @param before the same at the beginning of the step
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

  /** The level direction away from the other drone. */
  private static Vec3 aside(Vec3 offset) {
    Vec3 level = offset.horizontal();
    return level.equals(Vec3.ZERO) ? new Vec3(1, 0, 0) : level.normalized();
  }

  /**
   * Parts two drones.
   *
   * @param push from the other one to the one
   * @param passed what they went on after they touched; its part along the push is taken back
   */
  private static void part(SimDrone one, SimDrone other, Vec3 push, Vec3 passed) {
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
   * What one of the two gets of the push.
   *
   * @param way metres
   * @param stop what it loses of its velocity [m/s]
   * @param closing how fast they came together [m/s]
   */
  private record Share(double way, double stop, double closing) {}

  private static void push(SimDrone drone, SimDrone other, Vec3 normal, Share share) {
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
