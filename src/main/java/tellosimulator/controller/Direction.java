package tellosimulator.controller;

import tellosimulator.math.Vec3;

/**
 * The six directions, relative to the body, in which a drone can move. It can flip in all of them
 * except up and down.
 */
public enum Direction {
  FORWARD(new Vec3(1, 0, 0)),
  BACK(new Vec3(-1, 0, 0)),
  LEFT(new Vec3(0, 1, 0)),
  RIGHT(new Vec3(0, -1, 0)),
  UP(new Vec3(0, 0, 1)),
  DOWN(new Vec3(0, 0, -1));

  private final Vec3 unit;

  Direction(Vec3 unit) {
    this.unit = unit;
  }

  /**
   * Returns the unit vector of the direction in the level body frame: x along the nose, y to the
   * left, z up.
   */
  public Vec3 unit() {
    return unit;
  }
}
