package tellosimulator.scenery.overlay;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.FlightPhase;
import tellosimulator.scenery.drone.Livery;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Material;
import tellosimulator.scenery.mesh.Mesh;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.mesh.Shading;
import tellosimulator.scenery.mesh.Texture;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * The path that a drone has flown, as a thin tube in the air. Previous flights are fainter. While
 * another drone is selected, all flights of this drone are fainter. The last few points are in a
 * separate small mesh, which changes about eight times a second. The long mesh behind it is rebuilt
 * less often, mainly when the small mesh has reached its maximum size, or when the camera has moved
 * so far that the tube would look too thick or too thin. Measured: with a single mesh for each
 * path, the trails of twenty circling drones alone took up half of a processor. Not thread-safe.
 */
final class Trail {

  /** Maximum number of points. Decided: enough for minutes of flight, and cheap enough to draw. */
  private static final int CAPACITY = 384;

  /**
   * Maximum number of points in the mesh that changes often. Decided: few enough to rebuild it at
   * each update.
   */
  private static final int RECENT = 24;

  /** Minimum time between updates [ns]. Decided. */
  private static final long UPDATE_PERIOD = 120_000_000;

  /**
   * Height of the path above the drone's feet [m]. Documented: half of the drone's height of 41 mm.
   */
  private static final double MIDDLE = 0.02;

  private final Rgb color;
  private final FlightPaths paths = new FlightPaths(CAPACITY);
  private List<Instance> earlier = List.of();
  private List<Instance> settled = List.of();
  private List<Instance> recent = List.of();
  private Emphasis emphasis = Emphasis.NORMAL;
  private Material material;
  private LineWidth width = new LineWidth(Vec3.ZERO);
  private Pose last;
  private boolean changed;
  private long now;
  private long lastUpdate;

  /**
   * Index of the last point in the long mesh. The small mesh begins with the same point. Later
   * points may still move.
   */
  private int settledTo;

  private int sizeBefore;
  private int shownFlights;

  Trail(DroneSnapshot drone) {
    color = Livery.of(drone).color();
    material = material(1);
    last = drone.state().motion().pose();
  }

  /**
   * Follows the drone. The trail starts from scratch when the drone has been put back at its start.
   *
   * @param nanos time on any monotonic clock [ns]
   */
  void advance(DroneSnapshot drone, long nanos) {
    Pose pose = drone.state().motion().pose();
    if (!pose.equals(last) && pose.equals(drone.start())) {
      clear();
    }
    last = pose;
    boolean takingOff = drone.state().phase() == FlightPhase.TAKING_OFF;
    changed |= paths.advance(takingOff, pose.position().plusScaled(Vec3.UP, MIDDLE));
    now = nanos;
  }

  /** Removes all flights. The next update is due immediately. */
  void clear() {
    paths.clear();
    changed = true;
    lastUpdate = now - UPDATE_PERIOD;
  }

  /**
   * Returns all paths. The instances stay the same as long as nothing has changed. Meshes are built
   * only here, so a hidden trail costs next to nothing.
   *
   * @param camera position of the camera in the room frame [m]
   */
  List<Instance> instances(Vec3 camera, Emphasis wantedEmphasis) {
    LineWidth wanted = new LineWidth(camera);
    boolean faded = wantedEmphasis.opacity() != emphasis.opacity();
    if (faded) {
      emphasis = wantedEmphasis;
      material = material(1);
    }
    boolean resized = !wanted.equals(width) && !looksRight(wanted);
    boolean due = changed && now - lastUpdate >= UPDATE_PERIOD;
    if (resized || faded || due) {
      lastUpdate = now;
      changed = false;
      width = resized ? wanted : width;
      update(resized || faded);
    }
    List<Instance> all = new ArrayList<>(earlier);
    all.addAll(settled);
    all.addAll(recent);
    return all;
  }

  private boolean looksRight(LineWidth wanted) {
    return paths.present().looksRight(width, wanted)
        && paths.earlier().stream().allMatch(path -> path.looksRight(width, wanted));
  }

  /**
   * Rebuilds the meshes that have changed.
   *
   * @param all whether to rebuild the meshes of all paths
   */
  private void update(boolean all) {
    boolean anotherFlight = paths.changes() != shownFlights;
    if (anotherFlight || all) {
      shownFlights = paths.changes();
      earlier = earlier();
    }
    FlightPath path = paths.present();
    int end = path.size() - 1;
    boolean rebuilt = all || anotherFlight || path.size() < sizeBefore; // cleared or thinned out
    if (rebuilt || end - settledTo >= RECENT) {
      settledTo = Math.max(0, end - 1);
      settled = tube(path, 0, settledTo, material);
    }
    recent = tube(path, settledTo, end, material);
    sizeBefore = path.size();
  }

  private List<Instance> earlier() {
    List<Instance> all = new ArrayList<>();
    int age = 1;
    for (FlightPath path : paths.earlier()) {
      all.addAll(tube(path, 0, path.size() - 1, material(FlightPaths.opacity(age))));
      age++;
    }
    return all;
  }

  /**
   * Returns the material of a path.
   *
   * @param opacity opacity before the drone's emphasis is applied, 0 to 1
   */
  private Material material(double opacity) {
    double shown = opacity * emphasis.opacity();
    Texture texture = new Texture(1, 1, new int[] {color.argb(shown)});
    return new Material(texture, shown < 1 ? Shading.TRANSLUCENT : Shading.UNLIT);
  }

  /** Returns a section of a path, or an empty list if the section has fewer than two points. */
  private List<Instance> tube(FlightPath path, int first, int end, Material material) {
    if (end <= first) {
      return List.of();
    }
    List<Vec3> positions = new ArrayList<>();
    for (int i = first; i <= end; i++) {
      positions.addAll(path.ring(i, width));
    }
    int sides = FlightPath.SIDES;
    int[] faces = new int[9 * 2 * sides * (end - first)];
    int next = 0;
    for (int near = 0; near < sides * (end - first); near += sides) {
      int far = near + sides;
      for (int side = 0; side < sides; side++) {
        int other = (side + 1) % sides;
        int[] quad = {near + side, near + other, far + other, near + side, far + other, far + side};
        for (int vertex : quad) {
          faces[next] = vertex; // the other two indices of the vertex stay 0
          next += 3;
        }
      }
    }
    Mesh mesh = new Mesh(Mesh.floats(positions), new float[] {0, 0, 1}, new float[] {0, 0}, faces);
    return List.of(Instance.atOrigin(new Part(mesh, material)));
  }
}
