package tellosimulator.report;

import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
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

/**
 * Small pictures of a flight: of the room, and of each drone's camera, at the same moments. For one
 * thread, once.
 */
final class FilmStrip {

  /** Size of a picture [pixels]. Decided: as large as the page shows it, in 1 s a picture. */
  private static final int WIDTH = 320;

  private static final int HEIGHT = 240;

  /** Shortest time between pictures [s]. */
  private static final double SHORTEST_STEP = 1;

  /**
   * Most pictures of all cameras together. Decided: about 3 MB, and drawn in less than a second.
   */
  private static final int MOST = 200;

  /** Decided: as the window looks at a drone, from behind, above and a little from the right. */
  private static final Attitude VIEW =
      Attitude.ofHeading(Math.toRadians(24))
          .after(new Attitude(Math.cos(Math.toRadians(10)), 0, Math.sin(Math.toRadians(10)), 0));

  private static final double FIELD_OF_VIEW = Math.toRadians(50);

  /** From the middle of what is looked at [m]. */
  private static final double DISTANCE = 1.8;

  /** What is seen beside the room. */
  private static final int OUTSIDE = 0xd8dde3;

  private final FlightSnapshots snapshots;
  private final SceneBuilder scenes = new SceneBuilder();
  private final SoftwareCamera camera = new SoftwareCamera(new RenderCache(ColorSpace.RGB));
  private final FrameBuffer frameBuffer = FrameBuffer.forScreen(WIDTH, HEIGHT);
  private final int[] pixels = new int[WIDTH * HEIGHT];

  FilmStrip(FlightSnapshots snapshots) {
    this.snapshots = snapshots;
  }

  /** The pictures of a time as the page has them. */
  Map<String, Object> of(double begin, double end) {
    List<Double> times = times(begin, end, 1 + snapshots.at(begin).drones().size());
    List<String> room = new ArrayList<>();
    Map<Integer, List<String>> cameras = new TreeMap<>();
    try (JpegEncoder encoder = new JpegEncoder(WIDTH, HEIGHT)) {
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
    Map<String, Object> film = new LinkedHashMap<>();
    film.put("times", times);
    film.put("room", room);
    film.put("cameras", cameras);
    return film;
  }

  /**
   * @param cameras how many pictures there are of each moment
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

  /** The middle between all drones at a moment, and how far they are from it [m]. */
  private static Focus focus(SimSnapshot snapshot) {
    List<Vec3> places =
        snapshot.drones().stream().map(drone -> drone.state().motion().position()).toList();
    Vec3 sum = places.stream().reduce(Vec3.ZERO, Vec3::plus);
    Vec3 middle = sum.times(1.0 / places.size());
    double reach = places.stream().mapToDouble(place -> place.minus(middle).norm()).max().orElse(0);
    return new Focus(middle, reach);
  }

  /**
   * What a camera looks at.
   *
   * @param reach how far from its middle things are [m]
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
