package tellosimulator.report;

import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import tellosimulator.json.Json;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.recording.FlightSnapshots;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.video.camera.CameraIntrinsics;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.video.camera.FrameBuffer;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.video.camera.RenderCache;
import tellosimulator.video.camera.SoftwareCamera;
import tellosimulator.video.picture.JpegEncoder;

/**
 * Renders small pictures of a flight. At regular intervals, there is one picture of the room and
 * one from each drone's camera. Not thread-safe; an instance can be used only once.
 */
final class FilmStrip {

  /** Width of a picture [pixels]. Decided: the page shows the pictures at about this width. */
  private static final int WIDTH = 320;

  private static final int HEIGHT = 240;

  /**
   * Compression quality. Decided: at this size, a higher quality makes no visible difference but
   * takes twice the space.
   */
  private static final float QUALITY = 0.62f;

  /** Minimum time between pictures [s]. */
  private static final double SHORTEST_STEP = 1;

  /**
   * Maximum total number of pictures from all cameras. Decided: they take about 3 MB, and are drawn
   * in less than a second.
   */
  private static final int MOST = 200;

  /**
   * Orientation of the room's camera. Decided: as in the window, from behind and above, and
   * slightly from the right.
   */
  private static final Attitude VIEW =
      Attitude.ofHeading(Math.toRadians(24))
          .after(new Attitude(Math.cos(Math.toRadians(10)), 0, Math.sin(Math.toRadians(10)), 0));

  private static final double FIELD_OF_VIEW = Math.toRadians(50);

  /** Minimum distance of the room's camera from the centre of the drones [m]. */
  private static final double DISTANCE = 1.8;

  /** Colour outside the room. */
  private static final int OUTSIDE = 0xd8dde3;

  /** An empty film strip, which the page does not show. */
  static final Map<String, Object> NONE =
      Map.of("times", List.of(), "room", List.of(), "cameras", Map.of());

  private final FlightSnapshots snapshots;
  private final SceneBuilder scenes = new SceneBuilder();
  private final SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final FrameBuffer frameBuffer = FrameBuffer.forScreen(WIDTH, HEIGHT);
  private final int[] pixels = new int[WIDTH * HEIGHT];

  FilmStrip(FlightSnapshots snapshots) {
    this.snapshots = snapshots;
  }

  /** Returns the pictures for a time span as members of the page's data. */
  Map<String, Object> of(double begin, double end) {
    List<Double> times = times(begin, end, 1 + snapshots.at(begin).drones().size());
    List<String> room = new ArrayList<>();
    Map<Integer, List<String>> cameras = new TreeMap<>();
    try (JpegEncoder encoder = new JpegEncoder(WIDTH, HEIGHT, QUALITY)) {
      for (double time : times) {
        SimSnapshot snapshot = snapshots.at(time);
        room.add(picture(scenes.scene(snapshot), room(snapshot), encoder));
        for (DroneSnapshot drone : snapshot.drones()) {
          int number = drone.state().drone();
          Pose pose = drone.state().motion().pose();
          PinholeCamera ahead = DroneOptics.DEFAULT.ahead(pose, WIDTH, HEIGHT);
          cameras
              .computeIfAbsent(number, each -> new ArrayList<>())
              .add(picture(scenes.scene(snapshot, number), ahead, encoder));
        }
      }
    }
    return Json.object("times", times, "room", room, "cameras", cameras);
  }

  /**
   * Returns the times at which pictures are taken.
   *
   * @param cameras the number of pictures at each time
   */
  static List<Double> times(double begin, double end, int cameras) {
    double length = Math.max(0, end - begin);
    int moments = Math.max(2, MOST / cameras);
    double step = Math.max(SHORTEST_STEP, length / (moments - 1));
    List<Double> times = new ArrayList<>();
    for (int i = 0; i * step <= length + 1e-6; i++) {
      times.add(Json.rounded(begin + i * step));
    }
    return times;
  }

  private static PinholeCamera room(SimSnapshot snapshot) {
    Focus focus = focus(snapshot);
    double distance = DISTANCE + 1.5 * focus.reach();
    Vec3 eye = focus.middle().minus(VIEW.toRoom(new Vec3(distance, 0, 0)));
    return new PinholeCamera(
        new Pose(eye, VIEW), new CameraIntrinsics(WIDTH, HEIGHT, FIELD_OF_VIEW), 0.05);
  }

  /** Returns the centre of all drones and their largest distance from it [m]. */
  private static Focus focus(SimSnapshot snapshot) {
    List<Vec3> places =
        snapshot.drones().stream().map(drone -> drone.state().motion().position()).toList();
    Vec3 sum = places.stream().reduce(Vec3.ZERO, Vec3::plus);
    Vec3 middle = sum.times(1.0 / places.size());
    double reach = places.stream().mapToDouble(place -> place.minus(middle).norm()).max().orElse(0);
    return new Focus(middle, reach);
  }

  /**
   * The area at which the room's camera looks.
   *
   * @param reach largest distance of a drone from the centre [m]
   */
  private record Focus(Vec3 middle, double reach) {}

  private String picture(Scene scene, PinholeCamera seenBy, JpegEncoder encoder) {
    camera.draw(scene, seenBy, frameBuffer);
    frameBuffer.copyTo(pixels);
    for (int i = 0; i < pixels.length; i++) {
      pixels[i] = pixels[i] == 0 ? OUTSIDE : pixels[i];
    }
    return Base64.getEncoder().encodeToString(encoder.encode(pixels));
  }
}
