package tellosimulator.world;

import java.util.List;
import java.util.Optional;
import tellosimulator.math.Vec3;
import tellosimulator.world.Obstacles.Part;
import tellosimulator.world.Solid.Penetration;

/**
 * The movement of one body past the nearby obstacles in one step. The movement is divided into
 * substeps that are shorter than the body, so that the body cannot pass through an obstacle at any
 * speed. Each instance can be used only once. Not thread-safe.
 */
final class Sweep {

  /**
   * Maximum length of a substep [m]. Decided: a quarter of a drone's smallest dimension, its
   * height.
   */
  private static final double STRETCH = 0.01;

  /**
   * Maximum number of passes that push a body out of all obstacles in one substep. Decided: the
   * limit ends the loop if two obstacles push the body back and forth.
   */
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

  /** Removes the components of velocity and movement that lead into the obstacle. */
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
