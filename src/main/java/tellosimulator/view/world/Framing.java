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
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.world.Orbit.Offset;
import tellosimulator.world.Arena;

/**
 * Fits the whole scene into what is free of the picture, and knows when it must be fitted anew:
 * when room, starts, goals, picture or panels have changed, or a drone has left the picture. For
 * one thread.
 */
final class Framing {

  /** Free air over a drone for which the camera went back [m]. Decided: it may fly on a little. */
  private static final double AIR = 0.5;

  /** In how many steps a part grows. Decided: an eighth of what panels cover can be told. */
  private static final int STEPS = 8;

  /** What differs by less is the same distance [m]. Decided: nobody sees it. */
  private static final double SAME = 1e-6;

  /** What has been fitted. */
  private record Subject(
      Arena arena, List<Pose> starts, List<Goal> goals, Map<Integer, Vec3> astray) {}

  private final double fieldOfView;
  private PictureArea picture = new PictureArea(new Dimension2D(0, 0), Insets.EMPTY, List.of());
  private List<Goal> goals = List.of();
  private Map<Integer, Vec3> astray = Map.of();
  private PictureArea fittedPicture = picture;
  private Subject fitted = new Subject(Arena.DEFAULT, List.of(), List.of(), Map.of());

  /**
   * @param fieldOfView from top to bottom of the picture [rad]
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

  /** Also shows where these are. */
  void setGoals(List<Goal> newGoals) {
    goals = List.copyOf(newGoals);
  }

  /** Whether the scene must be fitted anew. */
  boolean stale(SimSnapshot snapshot) {
    return !picture.isEmpty()
        && !(picture.equals(fittedPicture) && subject(snapshot).equals(fitted));
  }

  /** Whether it is only seen in a picture of another size. */
  boolean resized() {
    return !picture.size().equals(fittedPicture.size());
  }

  /** Drones that have left a picture belong to what must be seen, until the next fresh start. */
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

  /** Fits without the drones that had left a picture. */
  Orbit fitAfresh(SimSnapshot snapshot, Orbit direction) {
    astray = Map.of();
    return fit(snapshot, direction);
  }

  /**
   * Fits the scene as it is now.
   *
   * @param direction whose heading and elevation the camera keeps
   * @return about the middle of what is seen, in the room frame; the same if there is no picture
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
        nearest(floor, things, direction.attitude()), middle(union(floor, things)));
  }

  /**
   * The nearest place from which all points are seen. A free part of the picture may grow over its
   * covers, as long as none of the things is seen there, and none but far corners of the floor. Of
   * equally near places the lower part of the picture counts.
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

  /** Whether a place is seen in the upper half of the picture, if at all. */
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

  /** The middle of the largest free part of the picture. */
  Offset middle() {
    return picture.isEmpty()
        ? Offset.NONE
        : picture.free().stream()
            .max(Comparator.comparingDouble(part -> part.getWidth() * part.getHeight()))
            .map(part -> window(part).middle())
            .orElseThrow();
  }

  private ViewWindow window(Rectangle2D part) {
    return ViewWindow.of(fieldOfView, picture.size(), part);
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

  /** The middle of the box around some points. */
  private static Vec3 middle(List<Vec3> points) {
    Vec3 least = points.get(0);
    Vec3 most = points.get(0);
    for (Vec3 each : points) {
      least =
          new Vec3(
              Math.min(least.x(), each.x()),
              Math.min(least.y(), each.y()),
              Math.min(least.z(), each.z()));
      most =
          new Vec3(
              Math.max(most.x(), each.x()),
              Math.max(most.y(), each.y()),
              Math.max(most.z(), each.z()));
    }
    return least.plus(most).times(0.5);
  }
}
