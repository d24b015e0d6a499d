package tellosimulator.sim;

import tellosimulator.controller.DroneController;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneModel;
import tellosimulator.model.DroneSpec;
import tellosimulator.physics.QuadcopterDynamics;
import tellosimulator.physics.Setpoint;
import tellosimulator.time.SimTime;
import tellosimulator.world.Collision;

/**
 * A drone's body, which moves through the room and is stopped by what it touches. Confined to the
 * simulation thread.
 */
final class DroneBody {

  private final DroneModel model;
  private final DroneController controller;
  private final QuadcopterDynamics dynamics = new QuadcopterDynamics();
  private Vec3 before;

  DroneBody(DroneModel model, DroneController controller) {
    this.model = model;
    this.controller = controller;
    this.before = position();
  }

  /** Returns the number of the drone, from 1. */
  int number() {
    return model.drone();
  }

  Vec3 position() {
    return model.motion().position();
  }

  Vec3 velocity() {
    return model.motion().velocity();
  }

  /** Returns the position at the beginning of the step. */
  Vec3 before() {
    return before;
  }

  boolean resting() {
    return model.resting();
  }

  /** Returns the distance along a ray to the body [m]; infinite if the ray misses the body. */
  double distanceAlong(Vec3 origin, Vec3 direction) {
    return DroneSpec.COLLIDER.distance(position(), origin, direction);
  }

  void integrate(Vec3 wind) {
    before = position();
    Setpoint setpoint = controller.setpoint();
    if (model.resting() && setpoint instanceof Setpoint.MotorsOff) {
      dynamics.rest();
      return;
    }
    model.setMotion(dynamics.advance(model.motion(), setpoint, wind, SimTime.STEP));
    model.setPushed(dynamics.pushed());
  }

  void collide(CollisionWorld collisionWorld) {
    if (!model.resting()) {
      collisionWorld.obstacle(this).ifPresent(this::stopBy);
    }
    if (!model.resting()) {
      collisionWorld.surface(this).ifPresent(this::stopBy);
    }
  }

  void stopBy(Collision collision) {
    model.setMotion(model.motion().heldAt(collision.position(), collision.velocity()));
    controller.touch(collision);
  }

  /**
   * Makes a resting body subject to the dynamics again if it may have lost its support or overlaps
   * something.
   */
  void settle(CollisionWorld collisionWorld) {
    if (model.resting() && collisionWorld.unsettles(this)) {
      model.setMotion(model.motion());
    }
  }
}
