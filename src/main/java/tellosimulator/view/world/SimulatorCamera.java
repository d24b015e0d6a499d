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
import tellosimulator.sim.SimSnapshot;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.world.Room;

/**
 * The camera that shows the whole scene, or orbits the selected drone and follows it; what it sees
 * shows with the next beat. It is fitted to the scene, and stays so when that changes, until a hand
 * moves it. For the JavaFX thread.
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

  /** From where it begins to follow a drone [m]. Decided: one sees nose, shadow and floor. */
  private static final double FOLLOW_DISTANCE = 1.9;

  /** From where it chases a drone, or from nearer [m]. Decided: by eye. */
  private static final double CHASE_DISTANCE = 1.35;

  /** How far behind the drone it follows may be, as a part of its distance. Decided. */
  private static final double LAG = 0.25;

  /** How long a window that opens settles [s]. Decided: its panels have their sizes by then. */
  private static final double SETTLING = 1;

  /** Longest time between two beats that counts [s]. Decided: an idle window beats more slowly. */
  private static final double LONGEST_BEAT = 0.25;

  private final FxSimulation simulation;
  private final Framing framing = new Framing(FIELD_OF_VIEW);
  private final BooleanProperty following = new SimpleBooleanProperty(this, "following");
  private final BooleanProperty reducedMotion = new SimpleBooleanProperty(this, "reducedMotion");
  private final ReadOnlyObjectWrapper<Optional<RoomView>> view =
      new ReadOnlyObjectWrapper<>(this, "view", Optional.of(RoomView.START));
  private SmoothFollow follow;

  /** About the drone while it follows or chases it, else in the room frame. */
  private Orbit orbit = towards(RoomView.START, 2 * FOLLOW_DISTANCE);

  /** Whether it shows the whole scene, whatever becomes of that. */
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

  /** The view that was chosen; empty once a hand has moved the camera. */
  public ReadOnlyObjectProperty<Optional<RoomView>> viewProperty() {
    return view.getReadOnlyProperty();
  }

  /** Whether it keeps the selected drone in the middle, whatever the view. */
  public BooleanProperty followingProperty() {
    return following;
  }

  /** Whether it jumps from view to view. */
  public BooleanProperty reducedMotionProperty() {
    return reducedMotion;
  }

  /** Shows the room from a side, or the drone that it follows. */
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

  /** Shows the whole scene in the direction in which it looks. */
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

  /** About the drone with the drone in the middle of the picture, or all of the scene. */
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
      return; // which follows anyway
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

  /** Turns about the pivot as if a hand pulled the scene by some pixels, right and down. */
  public void turn(double rightPixels, double downPixels) {
    takeOver();
    orbit = orbit.turned(-rightPixels * TURN_PER_PIXEL, downPixels * TURN_PER_PIXEL);
  }

  /** Turns the scene about the vertical axis, clockwise seen from above. */
  void rotate(double degrees) {
    takeOver();
    orbit = orbit.turned(Math.toRadians(degrees), 0);
  }

  /**
   * Shifts the scene as if a hand pulled it by some pixels, right and down.
   *
   * @param pictureHeight height of the picture in pixels; the scene follows the pointer
   */
  void shift(double rightPixels, double downPixels, double pictureHeight) {
    takeOver();
    double metersPerPixel =
        2 * orbit.distance() * Math.tan(FIELD_OF_VIEW / 2) / Math.max(1, pictureHeight);
    orbit =
        orbit.shifted(-rightPixels * metersPerPixel, downPixels * metersPerPixel, roomDiagonal());
  }

  /** Comes nearer by some pixels of scrolling; negative goes away. */
  void zoom(double pixels) {
    zoomBy(Math.exp(pixels * ZOOM_PER_PIXEL));
  }

  /**
   * Comes nearer.
   *
   * @param factor by which things look larger
   */
  public void zoomBy(double factor) {
    takeOver();
    orbit = orbit.zoomed(1 / factor, Math.max(farthest(), orbit.distance()));
  }

  /** Where it is and how it looks, room frame; it looks along its x axis. */
  public Pose pose() {
    return shown().pose(Vec3.ZERO);
  }

  /** Distance from what it looks at [m]. */
  public double distance() {
    return shown().distance();
  }

  /** From where the scene is seen. */
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

  /** Shows where these are, too. */
  void setGoals(List<Goal> goals) {
    framing.setGoals(goals);
  }

  /** Whether it is on its way to another view. */
  boolean glides() {
    return transition.isPresent();
  }

  /**
   * Follows the drone, or what becomes of the scene.
   *
   * @param nanos the time of the picture [ns]
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

  /** A drone that was chosen is in the picture at once; the camera moves only if it must. */
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

  /** Moves smoothly from what is seen now to what will be seen. */
  private void depart() {
    boolean jumps = reducedMotion.get() || framing.picture().isEmpty();
    transition = jumps ? Optional.empty() : Optional.of(new CameraTransition(shown()));
  }

  /** A hand moves on from what is seen now. */
  private void takeOver() {
    Orbit seen = shown();
    Orbit about = seen.about(seen.shift().minus(pivot()));
    orbit = about.turned(chasing ? -follow.heading() : 0, 0);
    transition = Optional.empty();
    fitted = false;
    view.set(Optional.empty());
  }

  /** What is seen now, in the room frame. */
  private Orbit shown() {
    Orbit wanted = absolute(orbit);
    return transition.map(moving -> moving.towards(wanted)).orElse(wanted);
  }

  private Orbit absolute(Orbit own) {
    return own.about(own.shift().plus(pivot())).turned(chasing ? follow.heading() : 0, 0);
  }

  /** What an orbit is about. */
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

  /** The heading of the drone's nose; a tilt of more than a quarter turn does not turn it. */
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

  /** From a corner of the room to the opposite one [m]. */
  double roomDiagonal() {
    Room room = simulation.roomProperty().get();
    return new Vec3(room.depth(), room.width(), room.height()).norm();
  }
}
