package tellosimulator.scenery.drone;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.drone.Loft.Section;
import tellosimulator.scenery.mesh.Mesh;

/**
 * The shape of a Tello without its propellers: shell, nose, arms, motors, feet and guards. All
 * positions are in the body frame [m], whose origin is between the feet.
 */
final class BodyMesh {

  /** Distance between front and back motors [m]. Documented: 98 mm (Tello User Manual). */
  static final double LENGTH = 0.098;

  /** Distance between left and right motors [m]. Documented: 92.5 mm (Tello User Manual). */
  static final double WIDTH = 0.0925;

  /**
   * Height of the plane of the propellers [m]. Documented: the drone is 41 mm high in total (Tello
   * User Manual).
   */
  static final double PROPELLER_HEIGHT = 0.0385;

  /** Position of the shell's front end [m]. Assumed: by eye, from pictures. */
  static final double NOSE = 0.0495;

  /** Height of the camera and of the status light [m]. Assumed: by eye, from pictures. */
  static final double LENS_HEIGHT = 0.0185;

  /**
   * Radius of the circle along which a guard runs [m]. Assumed: 2 mm of clearance around a
   * propeller.
   */
  private static final double GUARD_RADIUS = 0.0405;

  /** Overall width, including the guards [m]. */
  static final double SPAN = WIDTH + 2 * GUARD_RADIUS;

  /** Half the angle that a guard covers [rad]. Assumed: by eye, from pictures. */
  private static final double GUARD_HALF_ANGLE = Math.toRadians(88);

  private static final int ROUND = 12;

  /** The signs of x and y of the four motors: front left, front right, back left, back right. */
  private static final int[][] CORNERS = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

  private final SmoothMeshBuilder mesh = new SmoothMeshBuilder();

  private BodyMesh() {
    Shell.addTo(mesh);
    for (int[] corner : CORNERS) {
      addArm(corner[0], corner[1]);
      addMotor(corner[0], corner[1]);
      addGuard(corner[0], corner[1]);
    }
  }

  static SmoothMeshBuilder shape() {
    return new BodyMesh().mesh;
  }

  static Mesh create() {
    return shape().build();
  }

  /** Returns the centres of the four propellers: front left, front right, back left, back right. */
  static List<Vec3> propellers() {
    List<Vec3> all = new ArrayList<>();
    for (int[] corner : CORNERS) {
      all.add(motor(corner[0], corner[1]).withZ(PROPELLER_HEIGHT));
    }
    return all;
  }

  private static Vec3 motor(int front, int left) {
    return new Vec3(front * LENGTH / 2, left * WIDTH / 2, 0);
  }

  private void addArm(int front, int left) {
    Vec3 motor = motor(front, left);
    mesh.group(Palette.ARM);
    Loft.tube(
        mesh,
        List.of(
            new Section(new Vec3(front * 0.022, left * 0.012, 0.014), 0.0042),
            new Section(new Vec3(front * 0.034, left * 0.024, 0.0155), 0.0036),
            new Section(motor.withZ(0.0185), 0.0034)),
        8);
    mesh.group(Palette.ARM);
    Loft.bar(
        mesh,
        new Section(new Vec3(front * 0.013, left * 0.014, 0.018), 0.0018),
        new Section(motor.withZ(0.026), 0.0016),
        6);
  }

  private void addMotor(int front, int left) {
    Vec3 motor = motor(front, left);
    mesh.group(Palette.FOOT);
    Loft.tube(
        mesh,
        List.of(
            new Section(motor, 0.0022),
            new Section(motor.withZ(0.001), 0.0032),
            new Section(motor.withZ(0.009), 0.0052)),
        ROUND);
    mesh.group(Palette.ARM);
    Loft.bar(
        mesh,
        new Section(motor.withZ(0.009), 0.0058),
        new Section(motor.withZ(0.027), 0.0062),
        ROUND);
    mesh.group(Palette.CAP);
    Loft.bar(
        mesh,
        new Section(motor.withZ(0.027), 0.005),
        new Section(motor.withZ(0.0325), 0.005),
        ROUND);
    mesh.group(Palette.MOTOR);
    Loft.bar(
        mesh,
        new Section(motor.withZ(0.0325), 0.0011),
        new Section(motor.withZ(PROPELLER_HEIGHT - 0.0022), 0.0011),
        6);
    addHub(motor);
  }

  /** Adds the hub of a propeller. It is round, so it need not turn with the blades. */
  private void addHub(Vec3 motor) {
    mesh.group(Palette.PROPELLER);
    Loft.tube(
        mesh,
        List.of(
            new Section(motor.withZ(PROPELLER_HEIGHT - 0.0022), 0.004),
            new Section(motor.withZ(PROPELLER_HEIGHT + 0.0016), 0.004),
            new Section(motor.withZ(PROPELLER_HEIGHT + 0.0025), 0.0026)),
        ROUND);
  }

  private void addGuard(int front, int left) {
    Vec3 motor = motor(front, left);
    double outward = StrictMath.atan2(left * WIDTH, front * LENGTH);
    mesh.group(Palette.GUARD);
    int parts = 18;
    List<int[]> rings = new ArrayList<>();
    for (int i = 0; i <= parts; i++) {
      double angle = outward + GUARD_HALF_ANGLE * (2.0 * i / parts - 1);
      rings.add(guardSection(motor, angle));
    }
    addStrip(rings);
    for (double side : new double[] {-0.62, 0, 0.62}) {
      double angle = outward + GUARD_HALF_ANGLE * side;
      mesh.group(Palette.GUARD);
      Loft.bar(
          mesh,
          new Section(motor.withZ(0.022), 0.0014),
          new Section(onGuard(motor, angle, 0.0306), 0.0011),
          6);
    }
  }

  /** Adds a strip that is dark on its outside and underside, and light on its inside and top. */
  private void addStrip(List<int[]> rings) {
    for (int side = 0; side < 4; side++) {
      mesh.group(side < 2 ? Palette.RIM : Palette.GUARD);
      for (int i = 1; i < rings.size(); i++) {
        int[] near = rings.get(i - 1);
        int[] far = rings.get(i);
        int next = (side + 1) % 4;
        mesh.triangle(near[side], near[next], far[next]);
        mesh.triangle(near[side], far[next], far[side]);
      }
    }
    mesh.group(Palette.GUARD);
    Loft.cap(mesh, rings.get(rings.size() - 1), false);
    Loft.cap(mesh, rings.get(0), true);
  }

  /**
   * Adds a cross-section of an upright strip, 1.8 mm thick and 4.6 mm high. The corners are in this
   * order: inner lower, inner upper, outer upper, outer lower.
   */
  private int[] guardSection(Vec3 motor, double angle) {
    Vec3 out = new Vec3(StrictMath.cos(angle), StrictMath.sin(angle), 0).times(0.0009);
    Vec3 low = onGuard(motor, angle, 0.0285);
    Vec3 high = onGuard(motor, angle, 0.0331);
    return new int[] {
      mesh.vertex(low.minus(out)),
      mesh.vertex(high.minus(out)),
      mesh.vertex(high.plus(out)),
      mesh.vertex(low.plus(out))
    };
  }

  private static Vec3 onGuard(Vec3 motor, double angle, double height) {
    return new Vec3(
        motor.x() + GUARD_RADIUS * StrictMath.cos(angle),
        motor.y() + GUARD_RADIUS * StrictMath.sin(angle),
        height);
  }
}
