package tellosimulator.view.gallery;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.goal.Goal;
import tellosimulator.goal.GoalMark;
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
 * Draws scenarios as they begin, with their goals and the rings of their drones, from above and
 * from so near that what tells one from the other fills the picture: obstacles, mission pads,
 * starts and goals. For one thread at a time.
 */
final class RoomCamera {

  /** Size of a picture [pixels]. Decided: twice as large as a card shows it, for smooth edges. */
  static final int WIDTH = 480;

  static final int HEIGHT = 320;

  /** Decided: as the window looks at a drone, from behind and a little from the right. */
  private static final double HEADING = Math.toRadians(24);

  /** How far it looks down [rad]. Decided: one sees the floor, and how high things are. */
  private static final double ELEVATION = Math.toRadians(32);

  /** From left to right [rad]. Decided: little distortion at the edges. */
  private static final double FIELD_OF_VIEW = Math.toRadians(40);

  /** How much of the picture is free between its edges and the things. Decided: by eye. */
  private static final double MARGIN = 0.06;

  /** Height over a goal that is seen too [m]. Decided: the number over a circle on a table. */
  private static final double TAG = 0.5;

  /** Least distance from the middle of the things [m]. Decided: one sees what is around them. */
  private static final double NEAREST = 3;

  private static final double NEAR = 0.05;

  private final SceneBuilder scenes = new SceneBuilder();
  private final SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final FrameBuffer frameBuffer = FrameBuffer.forScreen(WIDTH, HEIGHT);

  /** The pixels row by row, 8 bits each for alpha, red, green and blue; transparent outside. */
  int[] picture(Scenario scenario) {
    int[] argb = new int[WIDTH * HEIGHT];
    SimSnapshot beginning = beginning(calm(scenario.config()));
    List<GoalMark> marks = GoalMark.of(Progress.start(scenario.challenge()), beginning.arena());
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

  /** Small pictures of patterned walls show little but patterns. */
  private static SimConfig calm(SimConfig config) {
    return config.withDecor(config.arena().decor().withWalls(Walls.AUTO));
  }

  private static SimSnapshot beginning(SimConfig config) {
    return new Simulation(config, drone -> (peer, text) -> {}, report -> {}, List.of()).snapshot();
  }

  /** What must be seen. */
  private static List<Vec3> places(SimSnapshot snapshot, List<Goal> goals, List<GoalMark> marks) {
    List<Pose> starts = snapshot.drones().stream().map(DroneSnapshot::start).toList();
    List<Vec3> places = new ArrayList<>(SceneExtent.things(snapshot.arena(), starts, goals));
    marks.forEach(mark -> places.add(mark.place().middle().plusScaled(Vec3.UP, TAG)));
    return places;
  }

  /** From where all places are in the picture; there is at least one. */
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
   * What two opposite edges of the picture leave to see, in a plane through the camera: places that
   * are ahead of it by x and beside it by y are seen while y is at most x times the slope.
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

    /** How far ahead the camera can be at the most, so that all places are seen. */
    double farthestAhead() {
      return (lower - upper) / (2 * slope);
    }

    /** Where it is then between both edges. */
    double middle() {
      return (lower + upper) / 2;
    }
  }
}
