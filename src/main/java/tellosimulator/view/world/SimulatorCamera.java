package tellosimulator.view.world;

import java.util.List;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import tellosimulator.goal.Goal;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.orbit.Orbit;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.world.Room;

/**
 * The camera that shows the whole scene, or orbits and follows the selected drone. Changes become
 * visible at the next UI tick. The camera is fitted to the scene, and is fitted again when the
 * scene changes, until the user moves the camera. Confined to the JavaFX thread.
 *
 * <p>Methods for gestures take pixels; the factors for angles and distances are constants of this
 * class.
 */
public final class SimulatorCamera {

  /** Field of view from top to bottom [rad]. Decided: little distortion at the edges. */
  private static final double FIELD_OF_VIEW = Math.toRadians(38);

  /** Rotation per pixel [rad]. Decided: half a turn across 600 pixels. */
  private static final double TURN_PER_PIXEL = Math.PI / 600;

  /**
   * Change of the logarithm of the distance per scrolled pixel. Decided: 10 % for each notch of 40
   * pixels.
   */
  private static final double ZOOM_PER_PIXEL = 0.0025;

  /**
   * Height of a drone's middle above its feet [m]. Documented: half of the drone's height of 41 mm.
   */
  private static final Vec3 MIDDLE = new Vec3(0, 0, 0.02);

  /**
   * Distance at which the camera starts to follow a drone [m]. Decided: shows nose, shadow and
   * floor.
   */
  private static final double FOLLOW_DISTANCE = 1.9;

  /** Longest distance at which the camera starts to chase a drone [m]. Decided: by eye. */
  private static final double CHASE_DISTANCE = 1.35;

  /** Largest lag behind the followed drone, as a fraction of the camera's distance. Decided. */
  private static final double LAG = 0.25;

  /**
   * Time in which the layout of an opening window settles [s]. Decided: panels have reached their
   * final sizes by then.
   */
  private static final double SETTLING = 1;

  /**
   * Maximum time by which the camera's motion advances at a tick [s]. Decided: shorter than the
   * interval between the ticks of an idle window.
   */
  private static final double LONGEST_BEAT = 0.25;

  private final FxSimulation simulation;
  private final Framing framing = new Framing(FIELD_OF_VIEW);
  private final BooleanProperty following = new SimpleBooleanProperty(this, "following");
  private final BooleanProperty reducedMotion = new SimpleBooleanProperty(this, "reducedMotion");
  private final ReadOnlyObjectWrapper<Optional<RoomView>> view =
      new ReadOnlyObjectWrapper<>(this, "view", Optional.of(RoomView.START));
  private SmoothFollow follow;

  /**
   * The orbit, relative to the drone while following or chasing it, otherwise in the room frame.
   */
  private Orbit orbit = towards(RoomView.START, 2 * FOLLOW_DISTANCE);

  /** Whether the camera shows the whole scene, and is fitted again when the scene changes. */
  private boolean fitted = true;

  private boolean tracking;
  private boolean chasing;
  private Optional<CameraTransition> transition = Optional.empty();
  private long lastNanos;
  private double age;

  SimulatorCamera(FxSimulation simulation) {
    this.simulation = simulation;
    follow = followSelected();
    following.addListener((property, before, now) -> changeFollowing(now));
    simulation.selectedProperty().addListener((property, before, now) -> find(now));
  }

  /** The selected view; empty once the user has moved the camera. */
  public ReadOnlyObjectProperty<Optional<RoomView>> viewProperty() {
    return view.getReadOnlyProperty();
  }

  /** Whether the selected drone is kept in the middle, in every view. */
  public BooleanProperty followingProperty() {
    return following;
  }

  /** Whether the camera jumps from view to view instead of moving smoothly. */
  public BooleanProperty reducedMotionProperty() {
    return reducedMotion;
  }

  /** Shows the room, or the followed drone, from one of the views. */
  void look(RoomView wanted) {
    if (wanted == RoomView.START) {
      following.set(false);
    }
    depart();
    double distance = fitted ? FOLLOW_DISTANCE : orbit.distance();
    chasing = wanted == RoomView.CHASE;
    orbit = towards(wanted, chasing ? Math.min(distance, CHASE_DISTANCE) : distance);
    view.set(Optional.of(wanted));
    settle();
  }

  /** Shows the whole scene from the current direction. */
  void fit() {
    following.set(false);
    depart();
    orbit = absolute(orbit);
    if (chasing) {
      chasing = false;
      view.set(Optional.empty());
    }
    settle();
  }

  /** Centres the followed drone, or fits the whole scene. */
  private void settle() {
    fitted = !follows();
    orbit =
        fitted
            ? framing.fitAfresh(simulation.snapshot(), orbit)
            : orbit.about(Vec3.ZERO).seenAt(framing.middle());
  }

  private void changeFollowing(boolean now) {
    depart();
    tracking = now;
    if (chasing) {
      return; // chasing always follows the drone
    }
    if (now) {
      double distance = fitted ? FOLLOW_DISTANCE : orbit.distance();
      orbit = new Orbit(orbit.heading(), orbit.elevation(), distance, Vec3.ZERO);
      settle();
    } else if (view.get().isPresent()) {
      settle();
    } else {
      orbit = orbit.about(orbit.shift().plus(follow.point()));
    }
  }

  /** Rotates about the pivot, as if the scene were dragged to the right and down by some pixels. */
  public void turn(double rightPixels, double downPixels) {
    takeOver();
    orbit = orbit.turned(-rightPixels * TURN_PER_PIXEL, downPixels * TURN_PER_PIXEL);
  }

  /** Rotates the scene about the vertical axis, clockwise seen from above. */
  void rotate(double degrees) {
    takeOver();
    orbit = orbit.turned(Math.toRadians(degrees), 0);
  }

  /**
   * Pans the scene, as if it were dragged to the right and down by some pixels.
   *
   * @param pictureHeight the height of the view [px], needed to make the scene follow the pointer
   */
  void shift(double rightPixels, double downPixels, double pictureHeight) {
    takeOver();
    double metersPerPixel =
        2 * orbit.distance() * Math.tan(FIELD_OF_VIEW / 2) / Math.max(1, pictureHeight);
    orbit =
        orbit.shifted(-rightPixels * metersPerPixel, downPixels * metersPerPixel, roomDiagonal());
  }

  /** Zooms in by a number of scrolled pixels, or out if the number is negative. */
  void zoom(double pixels) {
    zoomBy(Math.exp(pixels * ZOOM_PER_PIXEL));
  }

  /**
   * Zooms in.
   *
   * @param factor the magnification
   */
  public void zoomBy(double factor) {
    takeOver();
    orbit = orbit.zoomed(1 / factor, Math.max(farthest(), orbit.distance()));
  }

  /** Returns the pose of the camera in the room frame. The camera looks along its x axis. */
  public Pose pose() {
    return shown().pose(Vec3.ZERO);
  }

  /** Returns the distance from the pivot [m]. */
  public double distance() {
    return shown().distance();
  }

  /** Returns the viewpoint from which the scene is seen. */
  Viewpoint viewpoint() {
    return viewpoint(shown());
  }

  private Viewpoint viewpoint(Orbit seen) {
    return new Viewpoint(
        seen.pose(Vec3.ZERO),
        FIELD_OF_VIEW,
        true,
        Math.max(0.02, seen.distance() * 0.05),
        seen.distance() + 3 * roomDiagonal());
  }

  /** Sets the goals that fitted views include. */
  void setGoals(List<Goal> goals) {
    framing.setGoals(goals);
  }

  /** Returns whether a transition to another view is in progress. */
  boolean glides() {
    return transition.isPresent();
  }

  /**
   * Moves the camera after the drone, or fits it to a changed scene.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos, PictureArea picture) {
    double seconds = lastNanos == 0 ? 0 : Math.min(LONGEST_BEAT, (nanos - lastNanos) / 1e9);
    lastNanos = nanos;
    age += seconds;
    framing.setPicture(picture);
    follow.advance(target(), droneHeading(), seconds, LAG * orbit.distance());
    transition.ifPresent(moving -> moving.advance(seconds));
    transition = transition.filter(moving -> !moving.over());
    if (fitted) {
      fitAgain(simulation.snapshot());
    }
  }

  private void fitAgain(SimSnapshot snapshot) {
    if (framing.stale(snapshot)) {
      if (age > SETTLING && !framing.resized()) {
        depart();
      }
      orbit = framing.fit(snapshot, orbit);
    } else {
      framing.watch(snapshot, viewpoint(orbit));
    }
  }

  /** Brings a newly selected drone into view. The camera moves only if necessary. */
  private void find(FxDroneModel drone) {
    Vec3 place = drone.poseProperty().get().position();
    if (follows()) {
      depart();
      follow = followSelected();
    } else if (!fitted && !framing.picture().shows(place, viewpoint(orbit))) {
      depart();
      orbit = orbit.about(place).seenAt(framing.middle());
    }
  }

  /** Starts a smooth transition from the current view to the next one. */
  private void depart() {
    boolean jumps = reducedMotion.get() || framing.picture().isEmpty();
    transition = jumps ? Optional.empty() : Optional.of(new CameraTransition(shown()));
  }

  /** Ends fitting and any transition, so that a gesture continues from the current view. */
  private void takeOver() {
    Orbit seen = shown();
    Orbit about = seen.about(seen.shift().minus(pivot()));
    orbit = about.turned(chasing ? -follow.heading() : 0, 0);
    transition = Optional.empty();
    fitted = false;
    view.set(Optional.empty());
  }

  /** Returns the orbit of the current view, in the room frame. */
  private Orbit shown() {
    Orbit wanted = absolute(orbit);
    return transition.map(moving -> moving.towards(wanted)).orElse(wanted);
  }

  private Orbit absolute(Orbit own) {
    return own.about(own.shift().plus(pivot())).turned(chasing ? follow.heading() : 0, 0);
  }

  /** Returns the target of the orbit: the followed point, or the room's origin. */
  private Vec3 pivot() {
    return follows() ? follow.point() : Vec3.ZERO;
  }

  private boolean follows() {
    return chasing || tracking;
  }

  private SmoothFollow followSelected() {
    Pose pose = simulation.selected().poseProperty().get();
    return new SmoothFollow(pose.position().plus(MIDDLE), pose.attitude().heading());
  }

  private Vec3 target() {
    return simulation.selected().poseProperty().get().position().plus(MIDDLE);
  }

  /**
   * Returns the heading of the drone's nose. While the drone is tilted by more than a quarter turn,
   * the followed heading is kept.
   */
  private double droneHeading() {
    Attitude attitude = simulation.selected().poseProperty().get().attitude();
    return attitude.up().z() > 0 ? attitude.heading() : follow.heading();
  }

  private static Orbit towards(RoomView wanted, double distance) {
    return new Orbit(wanted.heading(), wanted.elevation(), distance, Vec3.ZERO);
  }

  private double farthest() {
    return Math.max(8, 4 * roomDiagonal());
  }

  /** Returns the distance between opposite corners of the room [m]. */
  double roomDiagonal() {
    Room room = simulation.roomProperty().get();
    return new Vec3(room.depth(), room.width(), room.height()).norm();
  }
}
