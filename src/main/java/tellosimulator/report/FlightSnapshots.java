package tellosimulator.report;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import tellosimulator.math.Attitude;
import tellosimulator.math.Frames;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneState;
import tellosimulator.model.FlightPhase;
import tellosimulator.model.Motion;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordedRun.DroneEntry;
import tellosimulator.recording.Sample;
import tellosimulator.recording.Track;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;
import tellosimulator.world.Arena;
import tellosimulator.world.Cover;
import tellosimulator.world.Obstacle;

/** Rebuilds what could be seen at the moments of a recorded flight. For any thread. */
final class FlightSnapshots {

  private final SimSnapshot beginning;
  private final List<Track> tracks;

  FlightSnapshots(RecordedFlight flight) {
    beginning =
        new Simulation(config(flight), drone -> (peer, text) -> {}, report -> {}, List.of())
            .snapshot();
    tracks = flight.tracks();
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

  /** Image files need not be where the recording is looked at. */
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
    Cover cover = obstacle.cover();
    boolean readable =
        cover.pictures().values().stream().allMatch(file -> Files.isReadable(Path.of(file)));
    Cover plain = new Cover(cover.rgb(), cover.pattern(), Map.of());
    return readable
        ? obstacle
        : new Obstacle(
            obstacle.name(), obstacle.shape(), obstacle.foot(), obstacle.heading(), plain);
  }

  /** The room with all that is in it. */
  Arena arena() {
    return beginning.arena();
  }

  /** A moment, in simulated seconds since the simulation began. */
  SimSnapshot at(double time) {
    List<DroneSnapshot> drones = new ArrayList<>();
    for (DroneSnapshot drone : beginning.drones()) {
      drones.add(
          tracks.stream()
              .filter(track -> track.drone() == drone.state().drone())
              .findFirst()
              .map(track -> drone.withState(state(drone.state(), track.at(time), time)))
              .orElse(drone));
    }
    return beginning.withDrones(drones);
  }

  private static DroneState state(DroneState was, Sample sample, double time) {
    return new DroneState(
        was.drone(),
        SimTime.ZERO.plus(Math.max(0, time)),
        Motion.restingAt(new Pose(sample.position(), attitude(sample.angles()))),
        phase(sample.phase()),
        was.energy(),
        was.reference(),
        was.perception(),
        was.video());
  }

  private static Attitude attitude(Sample.Angles angles) {
    double pitch = Math.toRadians(angles.pitch()) / 2;
    double roll = Math.toRadians(angles.roll()) / 2;
    return Attitude.ofHeading(Frames.headingOfYaw(angles.heading()))
        .after(new Attitude(Math.cos(pitch), 0, -Math.sin(pitch), 0))
        .after(new Attitude(Math.cos(roll), Math.sin(roll), 0, 0));
  }

  /** That of its word, or as if it flew. */
  private static FlightPhase phase(String word) {
    String name = word.toUpperCase(Locale.ROOT).replace('-', '_');
    return Stream.of(FlightPhase.values())
        .filter(phase -> phase.name().equals(name))
        .findFirst()
        .orElse(FlightPhase.FLYING);
  }

  /** The middle between all drones at a moment, and how far they are from it [m]. */
  static Focus focus(SimSnapshot snapshot) {
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
  record Focus(Vec3 middle, double reach) {}
}
