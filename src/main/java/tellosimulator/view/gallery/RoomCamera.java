package tellosimulator.view.gallery;

import java.util.List;
import tellosimulator.goal.GoalMark;
import tellosimulator.goal.Progress;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.scenery.overlay.Eye;
import tellosimulator.scenery.overlay.Overlay;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;
import tellosimulator.world.Room;
import tellosimulator.world.Walls;

/**
 * Draws scenarios as they begin, with their goals and the rings of their drones, from outside of
 * the room and above, so that all of it is in the picture. For one thread at a time.
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

  /** How far it stands back from where the room fills the picture, in diagonals. Decided. */
  private static final double MARGIN = 0.04;

  private static final int CORNERS = 8;

  private static final double NEAR = 0.05;

  private final SceneBuilder scenes = new SceneBuilder();
  private final SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final FrameBuffer frameBuffer = FrameBuffer.forScreen(WIDTH, HEIGHT);

  /** The pixels row by row, 8 bits each for alpha, red, green and blue; transparent outside. */
  int[] picture(Scenario scenario) {
    int[] argb = new int[WIDTH * HEIGHT];
    SimSnapshot beginning = beginning(plain(scenario.config()));
    PinholeCamera overview = overview(beginning.room());
    Overlay goals = new Overlay(beginning);
    goals.show(GoalMark.of(Progress.start(scenario.challenge()), beginning.arena()), List.of());
    Scene scene =
        scenes
            .scene(beginning, overview.pose().position())
            .withOverlay(goals.instances(beginning, new Eye(overview.pose(), NEAR)));
    camera.draw(scene, overview, frameBuffer);
    frameBuffer.copyTo(argb);
    return argb;
  }

  /** Small pictures of patterned walls show little but patterns. */
  private static SimConfig plain(SimConfig config) {
    return config.withDecor(config.arena().decor().withWalls(Walls.PLAIN));
  }

  private static SimSnapshot beginning(SimConfig config) {
    return new Simulation(config, drone -> (peer, text) -> {}, report -> {}, List.of()).snapshot();
  }

  /** From where all corners of a room are in the picture. */
  static PinholeCamera overview(Room room) {
    CameraIntrinsics intrinsics = new CameraIntrinsics(WIDTH, HEIGHT, FIELD_OF_VIEW);
    Attitude view =
        Attitude.ofHeading(HEADING)
            .after(new Attitude(Math.cos(ELEVATION / 2), 0, Math.sin(ELEVATION / 2), 0));
    double across = WIDTH / 2.0 / intrinsics.focalLength();
    double down = HEIGHT / 2.0 / intrinsics.focalLength();
    Edges sides = new Edges(across);
    Edges ends = new Edges(down);
    for (int number = 0; number < CORNERS; number++) {
      Vec3 corner = view.toBody(corner(room, number));
      sides.add(corner.x(), corner.y());
      ends.add(corner.x(), corner.z());
    }
    double behind = MARGIN * Math.hypot(room.depth(), room.width());
    double ahead = Math.min(sides.farthestAhead(), ends.farthestAhead()) - behind;
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

  /**
   * @param number from 0 to 7; each of its bits is a side of the room
   */
  static Vec3 corner(Room room, int number) {
    return new Vec3(
        (number & 1) == 0 ? room.depth() / 2 : -room.depth() / 2,
        (number & 2) == 0 ? room.width() / 2 : -room.width() / 2,
        (number & 4) == 0 ? room.height() : 0);
  }
}
