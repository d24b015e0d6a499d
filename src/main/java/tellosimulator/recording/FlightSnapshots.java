package tellosimulator.recording;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import tellosimulator.command.LightCommands;
import tellosimulator.extension.BoardLights;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.Battery;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;
import tellosimulator.recording.RecordedRun.DroneEntry;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;
import tellosimulator.world.Arena;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;

/**
 * Reconstructs the snapshots of a recorded flight. Positions are interpolated between two samples.
 * Immutable.
 */
public final class FlightSnapshots {

  /**
   * Longest gap between samples that is interpolated [s]. Decided: more than the 0.8 s between the
   * samples of a day-long flight after thinning.
   */
  private static final double LONGEST_GAP = 2;

  /**
   * Maximum distance between consecutive samples of a drone in motion [m]. If the distance is
   * greater, the drone is assumed to have been moved by hand. Decided: it corresponds to 20 m/s.
   */
  private static final double FARTHEST = 1;

  private final SimSnapshot beginning;
  private final List<Track> tracks;

  /**
   * The lights of each drone's extension board, by drone number and by the time from which they
   * apply [s].
   */
  private final Map<Integer, NavigableMap<Double, BoardLights>> lights;

  /** Creates the snapshots of a recorded flight. */
  public FlightSnapshots(RecordedFlight flight) {
    this(
        new Simulation(config(flight), drone -> datagram -> {}, List.of()).snapshot(),
        flight.tracks(),
        lights(flight.commands()));
  }

  private FlightSnapshots(
      SimSnapshot beginning,
      List<Track> tracks,
      Map<Integer, NavigableMap<Double, BoardLights>> lights) {
    this.beginning = beginning;
    this.tracks = tracks;
    this.lights = lights;
  }

  private static Map<Integer, NavigableMap<Double, BoardLights>> lights(
      List<RecordedCommand> commands) {
    Map<Integer, NavigableMap<Double, BoardLights>> lights = new HashMap<>();
    for (RecordedCommand command : commands) {
      if (!command.outcome().wrong()) {
        LightCommands.order(command.text())
            .ifPresent(
                order -> {
                  NavigableMap<Double, BoardLights> own =
                      lights.computeIfAbsent(command.drone(), drone -> new TreeMap<>());
                  BoardLights before =
                      own.isEmpty() ? BoardLights.DARK : own.lastEntry().getValue();
                  SimTime moment = SimTime.ZERO.plus(Math.max(0, command.sent()));
                  own.put(command.sent(), before.after(order, moment));
                });
      }
    }
    return lights;
  }

  /**
   * Returns a copy of this flight in which all drones have one colour.
   *
   * @param rgb the colour as {@code 0xrrggbb}
   */
  public FlightSnapshots withColor(int rgb) {
    List<DroneSnapshot> painted =
        beginning.drones().stream().map(drone -> drone.withColor(rgb)).toList();
    return new FlightSnapshots(beginning.withDrones(painted), tracks, lights);
  }

  private static SimConfig config(RecordedFlight flight) {
    SimConfig config =
        flight
            .scenario()
            .map(Scenario::config)
            .orElseGet(
                () ->
                    SimConfig.DEFAULT.withRoom(
                        flight.run().setting().room(), starts(flight.run().setting().drones())));
    return config.withArena(withReadablePictures(config.arena()));
  }

  private static List<Pose> starts(List<DroneEntry> drones) {
    return drones.isEmpty()
        ? SimConfig.DEFAULT.starts()
        : drones.stream().map(DroneEntry::start).toList();
  }

  /**
   * Removes pictures that cannot be read, because the image files may be missing on the machine
   * that shows the recording.
   */
  private static Arena withReadablePictures(Arena arena) {
    List<Obstacle> obstacles = arena.obstacles().stream().map(FlightSnapshots::readable).toList();
    return arena
        .withObstacles(obstacles)
        .withDecor(
            arena
                .decor()
                .withPosters(
                    arena.decor().posters().stream()
                        .filter(poster -> Files.isReadable(Path.of(poster.picture())))
                        .toList()));
  }

  private static Obstacle readable(Obstacle obstacle) {
    ObstacleAppearance appearance = obstacle.appearance();
    boolean readable =
        appearance.pictures().values().stream().allMatch(file -> Files.isReadable(Path.of(file)));
    ObstacleAppearance plain =
        new ObstacleAppearance(appearance.rgb(), appearance.pattern(), Map.of());
    return readable
        ? obstacle
        : new Obstacle(
            obstacle.name(), obstacle.shape(), obstacle.foot(), obstacle.heading(), plain);
  }

  /** The room with its contents. */
  public Arena arena() {
    return beginning.arena();
  }

  /**
   * Returns the snapshot at a time.
   *
   * @param time simulated seconds since the simulation began
   */
  public SimSnapshot at(double time) {
    SimTime moment = SimTime.ZERO.plus(Math.max(0, time));
    List<DroneSnapshot> drones = new ArrayList<>();
    for (DroneSnapshot drone : beginning.drones()) {
      drones.add(
          tracks.stream()
              .filter(track -> track.drone() == drone.state().drone())
              .findFirst()
              .map(track -> drone.withState(state(drone.state().at(moment), track, time)))
              .orElse(drone));
    }
    return new SimSnapshot(moment, beginning.clock(), beginning.seed(), beginning.arena(), drones);
  }

  private DroneState state(DroneState was, Track track, double time) {
    Sample sample = track.at(time);
    Sample next = track.after(sample);
    double percent = Math.max(0, Math.min(100, sample.batteryPercent()));
    return new DroneState(
        was.drone(),
        was.time(),
        motion(sample, next, time),
        phase(sample.phase()),
        new DroneState.Energy(
            new Battery(percent / 100), was.energy().temperature(), was.energy().motorTime()),
        was.reference(),
        was.perception(),
        was.video(),
        lights(was, phase(sample.phase()), time));
  }

  private BoardLights lights(DroneState was, FlightPhase phase, double time) {
    BoardLights shown =
        Optional.ofNullable(lights.get(was.drone()))
            .map(orders -> orders.floorEntry(time))
            .map(Map.Entry::getValue)
            .orElse(was.lights());
    return phase == FlightPhase.OFF ? shown.poweredOff() : shown;
  }

  private static Motion motion(Sample sample, Sample next, double time) {
    double gap = next.time() - sample.time();
    boolean joined =
        gap > 0
            && gap <= LONGEST_GAP
            && sample.position().distanceTo(next.position()) <= FARTHEST
            && time > sample.time();
    double part = joined ? Math.min(1, (time - sample.time()) / gap) : 0;
    Vec3 way = next.position().minus(sample.position());
    Pose pose =
        new Pose(
            sample.position().plusScaled(way, part),
            attitude(sample.angles()).towards(attitude(next.angles()), part));
    Motion resting = Motion.restingAt(pose);
    return resting.heldAt(pose.position(), sample.velocity());
  }

  private static Attitude attitude(Sample.Angles angles) {
    double pitch = Math.toRadians(angles.pitch()) / 2;
    double roll = Math.toRadians(angles.roll()) / 2;
    return Attitude.ofHeading(Frames.headingOfYaw(angles.heading()))
        .after(new Attitude(Math.cos(pitch), 0, -Math.sin(pitch), 0))
        .after(new Attitude(Math.cos(roll), Math.sin(roll), 0, 0));
  }

  /** Parses a flight phase; an unknown one counts as flying. */
  private static FlightPhase phase(String word) {
    String name = word.toUpperCase(Locale.ROOT).replace('-', '_');
    return Stream.of(FlightPhase.values())
        .filter(phase -> phase.name().equals(name))
        .findFirst()
        .orElse(FlightPhase.FLYING);
  }
}
