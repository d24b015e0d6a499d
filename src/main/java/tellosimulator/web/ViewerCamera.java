package tellosimulator.web;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.goal.Goal;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.SceneExtent;
import tellosimulator.scenery.orbit.Orbit;
import tellosimulator.scenery.orbit.RoomView;
import tellosimulator.scenery.orbit.ViewWindow;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.PinholeCamera;

/**
 * The camera with which one viewer looks at the room. It fits the whole scene until the viewer
 * moves it. Thread-safe.
 */
final class ViewerCamera {

  /** Field of view from top to bottom [rad]. Decided: the same as in the window. */
  private static final double FIELD_OF_VIEW = Math.toRadians(38);

  /** Distance of the near plane [m]. Decided: nearer than the nearest orbit. */
  static final double NEAR = 0.05;

  /** Distance of the camera that chases a drone [m]. Decided: the same as in the window. */
  private static final double CHASE_DISTANCE = 1.35;

  /** Distance of the camera that follows a drone [m]. Decided: shows the drone and its goal. */
  private static final double FOLLOW_DISTANCE = 3;

  /** Rotation across the width of the picture [rad]. Decided: half a turn. */
  private static final double TURN = Math.PI;

  /** Farthest distance from the pivot [m]. Decided: the largest room. */
  private static final double FARTHEST = 100;

  private RoomView view = RoomView.START;
  private Orbit orbit = towards(RoomView.START, 1);
  private boolean fitted = true;
  private boolean following;

  private static Orbit towards(RoomView view, double distance) {
    return new Orbit(view.heading(), view.elevation(), distance, Vec3.ZERO);
  }

  /** Looks from one of the views. */
  synchronized void look(RoomView wanted) {
    view = wanted;
    following = false;
    fitted = wanted != RoomView.CHASE;
    orbit = towards(wanted, CHASE_DISTANCE);
  }

  /** Follows the drone, or ends that. */
  synchronized void follow() {
    if (following || view == RoomView.CHASE) {
      look(RoomView.START);
    } else {
      following = true;
      fitted = false;
      orbit = towards(view, FOLLOW_DISTANCE);
    }
  }

  /**
   * Rotates the camera.
   *
   * @param right the way of the pointer, as a fraction of the picture's width
   * @param down likewise, also of the width
   */
  synchronized void turn(double right, double down) {
    fitted = false;
    orbit = orbit.turned(TURN * right, TURN * down);
  }

  /**
   * Moves the camera nearer or farther away.
   *
   * @param factor the factor by which the distance is multiplied
   */
  synchronized void zoom(double factor) {
    fitted = false;
    orbit = orbit.zoomed(Math.max(0.1, Math.min(10, factor)), FARTHEST);
  }

  /**
   * Returns the camera for a picture.
   *
   * @param drone the number of the drone that is chased, from 1
   * @param goals goals that a fitted view includes
   */
  synchronized PinholeCamera at(
      SimSnapshot snapshot, int drone, List<Goal> goals, int width, int height) {
    double aspect = (double) width / height;
    if (fitted) {
      orbit = fit(snapshot, goals, aspect);
    }
    double across = 2 * Math.atan(Math.tan(FIELD_OF_VIEW / 2) * aspect);
    return new PinholeCamera(
        pose(snapshot, drone), new CameraIntrinsics(width, height, across), NEAR);
  }

  private Pose pose(SimSnapshot snapshot, int drone) {
    Pose seen = snapshot.drones().get(drone - 1).state().motion().pose();
    if (view != RoomView.CHASE) {
      return orbit.pose(following ? seen.position() : Vec3.ZERO);
    }
    double heading = Frames.wrapped(seen.attitude().heading());
    return orbit.turned(heading, 0).pose(seen.position());
  }

  private Orbit fit(SimSnapshot snapshot, List<Goal> goals, double aspect) {
    List<Vec3> points = new ArrayList<>(SceneExtent.floor(snapshot.arena().room()));
    List<Pose> starts = snapshot.drones().stream().map(DroneSnapshot::start).toList();
    points.addAll(SceneExtent.things(snapshot.arena(), starts, goals));
    double up = Math.tan(FIELD_OF_VIEW / 2);
    ViewWindow window = new ViewWindow(aspect * up, -aspect * up, up, -up);
    Orbit direction = towards(view, 1);
    return direction.seenFrom(
        window.nearest(points, direction.attitude()), SceneExtent.middle(points));
  }
}
