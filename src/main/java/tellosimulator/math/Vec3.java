package tellosimulator.math;

/**
 * An immutable vector of three components. The code that uses a vector defines its frame and unit.
 */
public record Vec3(double x, double y, double z) {

  public static final Vec3 ZERO = new Vec3(0, 0, 0);

  /** The upward unit vector. It is the same in the room frame and in the body frame. */
  public static final Vec3 UP = new Vec3(0, 0, 1);

  public Vec3 plus(Vec3 other) {
    return new Vec3(x + other.x, y + other.y, z + other.z);
  }

  public Vec3 minus(Vec3 other) {
    return new Vec3(x - other.x, y - other.y, z - other.z);
  }

  public Vec3 times(double factor) {
    return new Vec3(x * factor, y * factor, z * factor);
  }

  /** Returns this vector plus {@code other} times {@code factor}. */
  public Vec3 plusScaled(Vec3 other, double factor) {
    return new Vec3(x + other.x * factor, y + other.y * factor, z + other.z * factor);
  }

  public double dot(Vec3 other) {
    return x * other.x + y * other.y + z * other.z;
  }

  public Vec3 cross(Vec3 other) {
    return new Vec3(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  public double norm() {
    return Math.sqrt(dot(this));
  }

  /** Returns the distance from this point to {@code other}. */
  public double distanceTo(Vec3 other) {
    return minus(other).norm();
  }

  /** Returns the unit vector of the same direction, or the zero vector for the zero vector. */
  public Vec3 normalized() {
    double norm = norm();
    return norm == 0 ? ZERO : times(1 / norm);
  }

  /** Returns the component in the x-y plane. */
  public Vec3 horizontal() {
    return new Vec3(x, y, 0);
  }

  public Vec3 withZ(double newZ) {
    return new Vec3(x, y, newZ);
  }

  /** Returns this vector, shortened to the length {@code limit} if it is longer. */
  public Vec3 limitedTo(double limit) {
    double squared = dot(this);
    return squared <= limit * limit ? this : times(limit / Math.sqrt(squared));
  }

  /**
   * Returns this vector rotated about the vertical axis.
   *
   * @param angle the angle [rad], counter-clockwise seen from above
   */
  public Vec3 turned(double angle) {
    double cos = StrictMath.cos(angle);
    double sin = StrictMath.sin(angle);
    return new Vec3(x * cos - y * sin, x * sin + y * cos, z);
  }
}
