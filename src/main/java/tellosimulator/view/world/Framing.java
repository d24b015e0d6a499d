package tellosimulator.view.world;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javafx.geometry.Dimension2D;
import javafx.geometry.Insets;
import javafx.geometry.Rectangle2D;
import tellosimulator.goal.Goal;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.SceneExtent;
import tellosimulator.scenery.orbit.Orbit;
import tellosimulator.scenery.orbit.Orbit.Offset;
import tellosimulator.scenery.orbit.ViewWindow;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.world.Arena;

/**
 * Fits the whole scene into the uncovered part of the view, and detects when this must be repeated:
 * when the room, starts, goals, view or panels change, or when a drone leaves the view. Not
 * thread-safe.
 */
final class Framing {

  /**
   * Space to include above a drone that has left the view [m]. Decided: allows the drone to climb a
   * little further.
   */
  private static final double AIR = 0.5;

  /**
   * Number of steps in which a free part is extended behind controls. Decided: even an eighth of
   * the covered area makes a visible difference.
   */
  private static final int STEPS = 8;

  /** Difference below which distances count as equal [m]. Decided: not visible. */
  private static final double SAME = 1e-6;

  /** The contents that a fit includes. */
  private record Subject(
      Arena arena, List<Pose> starts, List<Goal> goals, Map<Integer, Vec3> astray) {}

  private final double fieldOfView;
  private PictureArea picture = new PictureArea(new Dimension2D(0, 0), Insets.EMPTY, List.of());
  private List<Goal> goals = List.of();
  private Map<Integer, Vec3> astray = Map.of();
  private PictureArea fittedPicture = picture;
  private Subject fitted = new Subject(Arena.DEFAULT, List.of(), List.of(), Map.of());

  /**
   * Creates a framing that has not fitted anything yet.
   *
   * @param fieldOfView the angle from top to bottom of the view [rad]
   */
  Framing(double fieldOfView) {
    this.fieldOfView = fieldOfView;
  }

  PictureArea picture() {
    return picture;
  }

  void setPicture(PictureArea newPicture) {
    picture = newPicture;
  }

  /** Sets the goals that a fit includes. */
  void setGoals(List<Goal> newGoals) {
    goals = List.copyOf(newGoals);
  }

  /** Returns whether the scene must be fitted again. */
  boolean stale(SimSnapshot snapshot) {
    return !picture.isEmpty()
        && !(picture.equals(fittedPicture) && subject(snapshot).equals(fitted));
  }

  /** Returns whether the size of the view has changed since the last fit. */
  boolean resized() {
    return !picture.size().equals(fittedPicture.size());
  }

  /**
   * Detects drones that have left the view. Later fits include these drones, until {@link
   * #fitAfresh} is called.
   */
  void watch(SimSnapshot snapshot, Viewpoint viewpoint) {
    for (DroneSnapshot drone : snapshot.drones()) {
      Vec3 place = drone.state().motion().position();
      if (!picture.isEmpty() && !picture.shows(place, viewpoint)) {
        Map<Integer, Vec3> more = new TreeMap<>(astray);
        more.put(drone.state().drone(), place);
        astray = Map.copyOf(more);
      }
    }
  }

  /** Fits the scene, no longer including the places of drones that have left the view. */
  Orbit fitAfresh(SimSnapshot snapshot, Orbit direction) {
    astray = Map.of();
    return fit(snapshot, direction);
  }

  /**
   * Fits the scene as it is now.
   *
   * @param direction the orbit whose heading and elevation are kept
   * @return an orbit about the middle of the visible content, in the room frame; {@code direction}
   *     if the view is empty
   */
  Orbit fit(SimSnapshot snapshot, Orbit direction) {
    if (picture.isEmpty()) {
      return direction;
    }
    fittedPicture = picture;
    fitted = subject(snapshot);
    List<Vec3> floor = SceneExtent.floor(fitted.arena.room());
    List<Vec3> things = things();
    return direction.seenFrom(
        nearest(floor, things, direction.attitude()), SceneExtent.middle(union(floor, things)));
  }

  /**
   * Returns the nearest camera position from which all points are visible. A free part of the view
   * may be extended behind controls, provided that the controls hide no object and no corner of the
   * floor, except corners in the upper half of the view. If positions are equally near, the
   * position that uses the lower part of the view is preferred.
   */
  private Vec3 nearest(List<Vec3> floor, List<Vec3> things, Attitude attitude) {
    List<Vec3> points = union(floor, things);
    Vec3 nearest = Vec3.ZERO;
    double farthestAhead = Double.NEGATIVE_INFINITY;
    for (Rectangle2D part : picture.free()) {
      for (int step = 0; step <= STEPS; step++) {
        Rectangle2D larger = picture.between(part, (double) step / STEPS);
        for (Rectangle2D each : List.of(larger, picture.downwards(larger))) {
          Vec3 place = window(each).nearest(points, attitude);
          double ahead = attitude.toBody(place).x();
          boolean free = step == 0 && each.equals(part);
          if (ahead > farthestAhead - SAME
              && (free || shows(floor, things, new Pose(place, attitude)))) {
            nearest = place;
            farthestAhead = ahead;
          }
        }
      }
    }
    return nearest;
  }

  private boolean shows(List<Vec3> floor, List<Vec3> things, Pose camera) {
    Viewpoint viewpoint = new Viewpoint(camera, fieldOfView, true, 0, Double.POSITIVE_INFINITY);
    return things.stream().allMatch(place -> picture.showsClearly(place, viewpoint))
        && floor.stream()
            .allMatch(corner -> picture.showsClearly(corner, viewpoint) || high(corner, viewpoint));
  }

  /** Returns whether a place is visible in the upper half of the view. */
  private boolean high(Vec3 place, Viewpoint viewpoint) {
    double height = picture.size().getHeight();
    return viewpoint
        .project(place, picture.size().getWidth(), height)
        .filter(seen -> seen.getY() < height / 2)
        .isPresent();
  }

  private static List<Vec3> union(List<Vec3> one, List<Vec3> other) {
    List<Vec3> all = new ArrayList<>(one);
    all.addAll(other);
    return all;
  }

  /** Returns the offset of the middle of the largest free part from the middle of the view. */
  Offset middle() {
    return picture.isEmpty()
        ? Offset.NONE
        : picture.free().stream()
            .max(Comparator.comparingDouble(part -> part.getWidth() * part.getHeight()))
            .map(part -> window(part).middle())
            .orElseThrow();
  }

  private ViewWindow window(Rectangle2D part) {
    double halfWidth = picture.size().getWidth() / 2;
    double halfHeight = picture.size().getHeight() / 2;
    return ViewWindow.of(
        halfHeight / Math.tan(fieldOfView / 2),
        halfWidth - part.getMinX(),
        halfWidth - part.getMaxX(),
        halfHeight - part.getMinY(),
        halfHeight - part.getMaxY());
  }

  private Subject subject(SimSnapshot snapshot) {
    List<Pose> starts = snapshot.drones().stream().map(DroneSnapshot::start).toList();
    return new Subject(snapshot.arena(), starts, goals, astray);
  }

  private List<Vec3> things() {
    List<Vec3> points =
        new ArrayList<>(SceneExtent.things(fitted.arena, fitted.starts, fitted.goals));
    for (Vec3 place : fitted.astray.values()) {
      points.add(place);
      points.add(place.plusScaled(Vec3.UP, AIR));
    }
    return points;
  }
}
