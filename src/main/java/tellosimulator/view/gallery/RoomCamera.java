package tellosimulator.view.gallery;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.goal.Goal;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Progress;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.scenery.SceneExtent;
import tellosimulator.scenery.overlay.Eye;
import tellosimulator.scenery.overlay.Overlay;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;
import tellosimulator.world.Walls;

/**
 * Draws pictures of scenarios in their initial state, seen obliquely from above, with their goals
 * and the heading rings of their drones. The camera is so close that the obstacles, mission pads,
 * starts and goals fill the picture. Not thread-safe.
 */
final class RoomCamera {

  /** Width of a picture [pixels]. Decided: twice the width on a card, for smooth edges. */
  static final int WIDTH = 480;

  /** Height of a picture [pixels]. Decided: twice the height on a card, for smooth edges. */
  static final int HEIGHT = 320;

  /**
   * Heading of the camera, counter-clockwise from the room's x axis [rad]. Decided: like the
   * window's view of a drone, from behind and slightly from the right.
   */
  private static final double HEADING = Math.toRadians(24);

  /**
   * Downward angle of the camera [rad]. Decided: shows both the floor and the height of objects.
   */
  private static final double ELEVATION = Math.toRadians(32);

  /** Horizontal field of view [rad]. Decided: little distortion at the edges. */
  private static final double FIELD_OF_VIEW = Math.toRadians(40);

  /** Fraction of the picture kept free at its edges. Decided: by eye. */
  private static final double MARGIN = 0.06;

  /**
   * Height of the space above each goal that must also be visible [m]. Decided: the number of a
   * goal on the floor or on an obstacle floats in this space.
   */
  private static final double TAG = 0.5;

  /**
   * Minimum distance of the camera from the centre of the objects [m]. Decided: keeps their
   * surroundings visible.
   */
  private static final double NEAREST = 3;

  /** Distance from the camera to the near plane [m]. */
  private static final double NEAR = 0.05;

  private final SceneBuilder scenes = new SceneBuilder();
  private final SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final FrameBuffer frameBuffer = FrameBuffer.forScreen(WIDTH, HEIGHT);

  /**
   * Returns the pixels of a picture row by row, with 8 bits each for alpha, red, green and blue.
   * Pixels outside the room are transparent.
   */
  int[] picture(Scenario scenario) {
    int[] argb = new int[WIDTH * HEIGHT];
    SimSnapshot beginning = beginning(calm(scenario.config()));
    List<PlacedGoal> marks = PlacedGoal.of(Progress.start(scenario.challenge()), beginning.arena());
    PinholeCamera overview = overview(places(beginning, scenario.challenge().goals(), marks));
    Overlay goals = new Overlay(beginning);
    goals.show(marks, List.of());
    Scene scene =
        scenes
            .scene(beginning, overview.pose().position())
            .withOverlay(goals.instances(beginning, new Eye(overview.pose(), NEAR)));
    camera.draw(scene, overview, frameBuffer);
    frameBuffer.copyTo(argb);
    return argb;
  }

  /** Removes the walls' patterns, which would dominate a small picture. */
  private static SimConfig calm(SimConfig config) {
    return config.withDecor(config.arena().decor().withWalls(Walls.AUTO));
  }

  private static SimSnapshot beginning(SimConfig config) {
    return new Simulation(config, drone -> datagram -> {}, List.of()).snapshot();
  }

  /** Returns the places that must be visible, in the room frame [m]. */
  private static List<Vec3> places(SimSnapshot snapshot, List<Goal> goals, List<PlacedGoal> marks) {
    List<Pose> starts = snapshot.drones().stream().map(DroneSnapshot::start).toList();
    List<Vec3> places = new ArrayList<>(SceneExtent.things(snapshot.arena(), starts, goals));
    marks.forEach(mark -> places.add(mark.place().middle().plusScaled(Vec3.UP, TAG)));
    return places;
  }

  /** Returns a camera that sees all given places; there must be at least one. */
  static PinholeCamera overview(List<Vec3> places) {
    CameraIntrinsics intrinsics = new CameraIntrinsics(WIDTH, HEIGHT, FIELD_OF_VIEW);
    Attitude view =
        Attitude.ofHeading(HEADING)
            .after(new Attitude(Math.cos(ELEVATION / 2), 0, Math.sin(ELEVATION / 2), 0));
    double across = WIDTH / 2.0 / intrinsics.focalLength();
    double down = HEIGHT / 2.0 / intrinsics.focalLength();
    Edges sides = new Edges(across * (1 - MARGIN));
    Edges ends = new Edges(down * (1 - MARGIN));
    double middle = 0;
    for (Vec3 place : places) {
      Vec3 seen = view.toBody(place);
      sides.add(seen.x(), seen.y());
      ends.add(seen.x(), seen.z());
      middle += seen.x() / places.size();
    }
    double fitting = Math.min(sides.farthestAhead(), ends.farthestAhead());
    double ahead = Math.min(fitting, middle - NEAREST);
    Vec3 eye = view.toRoom(new Vec3(ahead, sides.middle(), ends.middle()));
    return new PinholeCamera(new Pose(eye, view), intrinsics, NEAR);
  }

  /**
   * The bounds that two opposite edges of the picture impose on the camera's position, in a plane
   * through the camera. A place is visible if its lateral distance from the camera's axis is at
   * most the slope times its distance ahead of the camera.
   */
  private static final class Edges {

    private final double slope;
    private double upper = Double.NEGATIVE_INFINITY;
    private double lower = Double.POSITIVE_INFINITY;

    Edges(double slope) {
      this.slope = slope;
    }

    void add(double x, double y) {
      upper = Math.max(upper, y - slope * x);
      lower = Math.min(lower, y + slope * x);
    }

    /** Returns how far ahead the camera can be on its axis so that all places are still visible. */
    double farthestAhead() {
      return (lower - upper) / (2 * slope);
    }

    /** Returns the lateral position of the camera at {@link #farthestAhead}. */
    double middle() {
      return (lower + upper) / 2;
    }
  }
}
