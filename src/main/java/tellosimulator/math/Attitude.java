package tellosimulator.math;

/**
 * An orientation as a unit quaternion that rotates vectors of the body frame (x along the nose, y
 * to the left, z up) into the room frame.
 *
 * <p>All methods use only basic arithmetic, square roots and {@code StrictMath}, so that a flight
 * is bit-identical on every machine.
 */
public record Attitude(double w, double x, double y, double z) {

  /** The level attitude, with the nose along the room's x axis. */
  public static final Attitude LEVEL = new Attitude(1, 0, 0, 0);

  /**
   * Returns a level orientation with the given heading.
   *
   * @param heading the heading [rad], counter-clockwise seen from above, 0 along x
   */
  public static Attitude ofHeading(double heading) {
    return new Attitude(StrictMath.cos(heading / 2), 0, 0, StrictMath.sin(heading / 2));
  }

  /**
   * Returns the smallest rotation that brings the vertical axis to {@code up}.
   *
   * @param up a unit vector in the room frame. If it points straight down, the rotation is a half
   *     turn about x
   */
  public static Attitude tiltedTo(Vec3 up) {
    double w = 1 + up.z();
    return w < 1e-9 ? new Attitude(0, 1, 0, 0) : new Attitude(w, -up.y(), up.x(), 0).normalized();
  }

  /** Returns the orientation that results from applying this orientation after {@code first}. */
  public Attitude after(Attitude first) {
    return new Attitude(
        w * first.w - x * first.x - y * first.y - z * first.z,
        w * first.x + x * first.w + y * first.z - z * first.y,
        w * first.y - x * first.z + y * first.w + z * first.x,
        w * first.z + x * first.y - y * first.x + z * first.w);
  }

  public Attitude inverse() {
    return new Attitude(w, -x, -y, -z);
  }

  /** Transforms a vector from the body frame to the room frame. */
  public Vec3 toRoom(Vec3 body) {
    double tx = 2 * (y * body.z() - z * body.y());
    double ty = 2 * (z * body.x() - x * body.z());
    double tz = 2 * (x * body.y() - y * body.x());
    return new Vec3(
        body.x() + w * tx + y * tz - z * ty,
        body.y() + w * ty + z * tx - x * tz,
        body.z() + w * tz + x * ty - y * tx);
  }

  /** Transforms a vector from the room frame to the body frame. */
  public Vec3 toBody(Vec3 room) {
    return inverse().toRoom(room);
  }

  /** Returns the body's z axis in the room frame: the direction of the thrust. */
  public Vec3 up() {
    return new Vec3(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y));
  }

  /**
   * Returns the rotation from this orientation to {@code target}, as a rotation vector (axis times
   * angle) in the body frame [rad]. Twice the sine of half the angle approximates the angle, so the
   * length of the vector never exceeds 2.
   */
  public Vec3 errorTo(Attitude target) {
    Attitude turn = inverse().after(target);
    double sign = turn.w < 0 ? -2 : 2;
    return new Vec3(turn.x * sign, turn.y * sign, turn.z * sign);
  }

  /**
   * Returns this orientation after a short rotation.
   *
   * @param rate the angular velocity in the body frame [rad/s]
   * @param seconds the duration [s]; short enough that the rotation is at most a few hundredths of
   *     a turn, because sine and cosine are approximated
   */
  public Attitude advancedBy(Vec3 rate, double seconds) {
    Vec3 half = rate.times(seconds / 2);
    double squared = half.dot(half);
    double sine = 1 - squared / 6 * (1 - squared / 20);
    double cosine = 1 - squared / 2 * (1 - squared / 12);
    return after(new Attitude(cosine, half.x() * sine, half.y() * sine, half.z() * sine))
        .normalized();
  }

  /**
   * Interpolates along the shortest rotation to another orientation (normalised linear
   * interpolation).
   *
   * @param part the fraction of the rotation: 0 for this orientation, 1 for the other
   */
  public Attitude towards(Attitude other, double part) {
    double cosine = w * other.w + x * other.x + y * other.y + z * other.z;
    double more = cosine < 0 ? -part : part;
    double rest = 1 - part;
    return new Attitude(
            rest * w + more * other.w,
            rest * x + more * other.x,
            rest * y + more * other.y,
            rest * z + more * other.z)
        .normalized();
  }

  public Attitude normalized() {
    double factor = 1 / Math.sqrt(w * w + x * x + y * y + z * z);
    return new Attitude(w * factor, x * factor, y * factor, z * factor);
  }

  /** Returns the heading [rad]: counter-clockwise seen from above, 0 along x, within ±π. */
  public double heading() {
    return StrictMath.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  }

  /** Returns the elevation of the nose [rad]: nose up is positive, within ±π/2. */
  public double elevation() {
    double sine = 2 * (x * z - w * y);
    return StrictMath.asin(Math.max(-1, Math.min(1, sine)));
  }

  /** Returns the bank [rad]: right side down is positive, within ±π. */
  public double bank() {
    return StrictMath.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y));
  }
}
