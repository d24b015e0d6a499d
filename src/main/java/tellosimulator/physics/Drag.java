package tellosimulator.physics;

import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;

/** Linear and quadratic drag against the air. */
final class Drag {

  private Drag() {}

  /** Deceleration for each unit of speed [1/s] at a velocity against the air [m/s]. */
  static double factor(Vec3 velocity) {
    return DroneSpec.LINEAR_DRAG + DroneSpec.QUADRATIC_DRAG * velocity.norm();
  }
}
