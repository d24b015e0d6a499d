package tellosimulator.view.world;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.world.Room;

/**
 * The camera that orbits the selected drone and follows it; what it sees shows with the next beat.
 * For the JavaFX thread.
 *
 * <p>Methods that a person's hand moves take pixels; angles and distances come from constants here.
 */
public final class SimulatorCamera {

  /** Field of view from top to bottom [rad]. Decided: little distortion at the edges. */
  private static final double FIELD_OF_VIEW = Math.toRadians(38);

  /** Turn of the camera a pixel [rad]. Decided: half a turn across 600 pixels. */
  private static final double TURN_PER_PIXEL = Math.PI / 600;

  /**
   * Logarithm of the distance's change a pixel of scrolling. Decided: 10 % a notch of 40 pixels.
   */
  private static final double ZOOM_PER_PIXEL = 0.0025;

  /** Height of a drone's middle above its feet [m]. Documented: half of 41 mm. */
  private static final Vec3 MIDDLE = new Vec3(0, 0, 0.02);

  /**
   * From behind and above, a little from the right. Decided: one sees nose, shadow, floor and two
   * walls, so that one knows where in the room the drone is.
   */
  private static final double START_HEADING = Math.toRadians(24);

  private static final double START_ELEVATION = Math.toRadians(17);

  private static final double START_DISTANCE = 1.9;

  /** From where one looks at the drone's sides, or from nearer [m]. Decided: by eye. */
  private static final double LOOK_DISTANCE = 1.35;

  /** How far behind the drone it follows may be, as a part of its distance. Decided. */
  private static final double LAG = 0.25;

  private final FxSimulation simulation;
  private final SmoothFollow follow;
  private Orbit orbit = start();
  private boolean chasing;
  private long lastNanos;

  SimulatorCamera(FxSimulation simulation) {
    this.simulation = simulation;
    Pose pose = simulation.selected().poseProperty().get();
    follow = new SmoothFollow(pose.position().plus(MIDDLE), pose.attitude().heading());
  }

  /** Looks at the nose. */
  public void front() {
    look(droneHeading() + Math.PI, Math.toRadians(12), false);
  }

  /** Looks at the right side. */
  public void side() {
    look(droneHeading() + Math.PI / 2, Math.toRadians(8), false);
  }

  /** Looks down, the drone's nose up in the picture. */
  public void top() {
    look(droneHeading(), Orbit.HIGHEST, false);
  }

  /** Flies behind the drone and turns with it. */
  public void chase() {
    look(droneHeading(), Math.toRadians(18), true);
  }

  /** Back to the view of the beginning. */
  public void reset() {
    chasing = false;
    orbit = start();
  }

  /** Turns around the drone as if a hand pulled the scene by some pixels, right and down. */
  public void turn(double rightPixels, double downPixels) {
    orbit = orbit.turned(-rightPixels * TURN_PER_PIXEL, downPixels * TURN_PER_PIXEL);
  }

  /** Turns the scene about the vertical axis, clockwise seen from above. */
  public void rotate(double degrees) {
    orbit = orbit.turned(Math.toRadians(degrees), 0);
  }

  /**
   * Shifts the scene as if a hand pulled it by some pixels, right and down.
   *
   * @param pictureHeight height of the picture in pixels; the scene follows the pointer
   */
  public void shift(double rightPixels, double downPixels, double pictureHeight) {
    double metersPerPixel =
        2 * orbit.distance() * Math.tan(FIELD_OF_VIEW / 2) / Math.max(1, pictureHeight);
    orbit =
        orbit.shifted(-rightPixels * metersPerPixel, downPixels * metersPerPixel, farthestShift());
  }

  /** Comes nearer by some pixels of scrolling; negative goes away. */
  public void zoom(double pixels) {
    zoomBy(Math.exp(pixels * ZOOM_PER_PIXEL));
  }

  /**
   * Comes nearer.
   *
   * @param factor by which things look larger
   */
  public void zoomBy(double factor) {
    orbit = orbit.zoomed(1 / factor, farthest());
  }

  /** Where it is and how it looks, room frame; it looks along its x axis. */
  public Pose pose() {
    Orbit shown = chasing ? orbit.turned(follow.heading(), 0) : orbit;
    return shown.pose(follow.point());
  }

  /** Distance from what it looks at [m]. */
  public double distance() {
    return orbit.distance();
  }

  /** From where the scene is seen. */
  Viewpoint viewpoint() {
    double distance = orbit.distance();
    return new Viewpoint(
        pose(),
        FIELD_OF_VIEW,
        true,
        Math.max(0.02, distance * 0.05),
        distance + 3 * roomDiagonal());
  }

  /**
   * Follows the drone.
   *
   * @param nanos the time of the picture [ns]
   */
  void advance(long nanos) {
    double seconds = lastNanos == 0 ? 0 : Math.min(0.25, (nanos - lastNanos) / 1e9);
    lastNanos = nanos;
    FxDroneModel drone = simulation.selected();
    Vec3 target = drone.poseProperty().get().position().plus(MIDDLE);
    follow.advance(target, droneHeading(), seconds, LAG * orbit.distance());
  }

  /** The heading of the drone's nose; a tilt of more than a quarter turn does not turn it. */
  private double droneHeading() {
    Attitude attitude = simulation.selected().poseProperty().get().attitude();
    return attitude.up().z() > 0 ? attitude.heading() : follow.heading();
  }

  private void look(double heading, double elevation, boolean withDrone) {
    chasing = withDrone;
    double own = withDrone ? 0 : heading;
    orbit = new Orbit(own, elevation, Math.min(orbit.distance(), LOOK_DISTANCE), Vec3.ZERO);
  }

  private static Orbit start() {
    return new Orbit(START_HEADING, START_ELEVATION, START_DISTANCE, Vec3.ZERO);
  }

  private double farthest() {
    return Math.max(8, 2 * roomDiagonal());
  }

  private double farthestShift() {
    return roomDiagonal();
  }

  /** From a corner of the room to the opposite one [m]. */
  double roomDiagonal() {
    Room room = simulation.roomProperty().get();
    return new Vec3(room.depth(), room.width(), room.height()).norm();
  }
}
