package tellosimulator.world;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Vec3;
import tellosimulator.world.Obstacles.Part;
import tellosimulator.world.Solid.Penetration;

/**
 * One body's way through one step, past the obstacles nearby. It goes in stretches that are shorter
 * than a body is thick, so nothing is passed through at any speed. For one thread, once.
 */
final class Sweep {

  /** Longest stretch [m]. Decided: a quarter of the height of a drone, the thinner way through. */
  private static final double STRETCH = 0.01;

  /** How often a body is pushed out in one place: from a wall into another, and back. Decided. */
  private static final int MOST_PUSHES = 4;

  private final List<Part> near;
  private final Collider collider;
  private Vec3 velocity = Vec3.ZERO;
  private Vec3 stretch = Vec3.ZERO;
  private Optional<Collision> worst = Optional.empty();

  Sweep(List<Part> near, Collider collider) {
    this.near = near;
    this.collider = collider;
  }

  Optional<Collision> along(Vec3 from, Vec3 to, Vec3 atVelocity) {
    Vec3 way = to.minus(from);
    int count = Math.max(1, (int) Math.ceil(way.norm() / STRETCH));
    stretch = way.times(1.0 / count);
    velocity = atVelocity;
    Vec3 position = from;
    for (int i = 0; i < count; i++) {
      Vec3 before = position;
      position = pushedOut(position.plus(stretch), before);
    }
    Vec3 end = position;
    return worst.map(hit -> new Collision(hit.touched(), hit.normal(), hit.speed(), end, velocity));
  }

  private Vec3 pushedOut(Vec3 position, Vec3 before) {
    Vec3 place = position;
    for (int push = 0; push < MOST_PUSHES; push++) {
      boolean free = true;
      for (Part part : near) {
        Optional<Penetration> inside = part.solid().penetration(place, before, collider);
        if (inside.isPresent()) {
          place = place.plusScaled(inside.get().normal(), inside.get().depth());
          stop(part.obstacle(), inside.get().normal(), place);
          free = false;
        }
      }
      if (free) {
        return place;
      }
    }
    return place;
  }

  /** Takes from the body what leads into the obstacle. */
  private void stop(Obstacle obstacle, Vec3 normal, Vec3 place) {
    double speed = -velocity.dot(normal);
    if (speed > 0) {
      velocity = velocity.plusScaled(normal, speed);
    }
    double further = -stretch.dot(normal);
    if (further > 0) {
      stretch = stretch.plusScaled(normal, further);
    }
    if (worst.isEmpty() || speed > worst.get().speed()) {
      worst = Optional.of(new Collision(obstacle, normal, Math.max(0, speed), place, velocity));
    }
  }
}
