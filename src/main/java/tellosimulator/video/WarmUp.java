package tellosimulator.video;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import tellosimulator.command.Link;
import tellosimulator.concurrent.Verdict;
import tellosimulator.concurrent.Worker;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneModel;
import tellosimulator.model.Motion;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Outlets;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.Clock;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.time.SimTime;

/**
 * Films and encodes pictures before anybody asks for them, on a thread of its own, so that the Java
 * machine has compiled what it takes, and what there is to see is painted, when an operator does.
 * For any thread.
 */
public final class WarmUp implements AutoCloseable {

  private static final String NAME = "video-warm-up";
  private static final Verdict FAILED = Verdict.finish("The first pictures could not be made");
  private static final VideoFormat FORMAT = VideoFormat.of(VideoSettings.DEFAULT);

  /** How many pictures. Measured: after these a picture takes hardly longer than after many. */
  private static final int PICTURES = 60;

  /**
   * How far the camera turns from picture to picture [rad]. Decided: as a drone at 60 degrees/s.
   */
  private static final double TURN = Math.toRadians(2);

  /**
   * How long it rests before it films a simulation [ms]. Decided: longer than a program takes that
   * asks for pictures right after the start, which shall have the processors to itself.
   */
  private static final int REST_MS = 400;

  /**
   * Whether the heap has room for pictures that nobody has asked for. Measured: a film takes 36 MB;
   * with 32 MB, filming in advance took the memory that the start itself needed.
   */
  private static final boolean AFFORDABLE = Runtime.getRuntime().maxMemory() >= 64L << 20;

  private final Films films;
  private final CountDownLatch closed = new CountDownLatch(1);

  /**
   * Does nothing yet.
   *
   * @param films of which it makes one for each of its threads
   */
  public WarmUp(Films films) {
    this.films = films;
  }

  /**
   * Makes the first picture of a drone on the floor of the default room, while the program still
   * starts; no simulation has to be there yet. It also paints that room and loads all code.
   */
  public void beginEarly() {
    if (AFFORDABLE) {
      Worker.once(NAME, FAILED, () -> films.prepareEarly(beforeTheStart()));
    }
  }

  /**
   * Makes the first picture of a simulation's first drone, unless {@link #beginEarly} has made or
   * is making it with the same films; only after that is a program ready to film.
   *
   * @param itsFilms of this simulation
   */
  public static void finishEarly(Films itsFilms, SimSnapshot snapshot) {
    if (!AFFORDABLE) {
      return;
    }
    try {
      itsFilms.prepare(snapshot);
    } catch (RuntimeException | Error e) { // it can be made later
      FAILED.tell(e);
    }
  }

  /**
   * Films the first drone of a simulation, a moment later.
   *
   * @param snapshots the newest one
   */
  public void begin(Supplier<SimSnapshot> snapshots) {
    if (!AFFORDABLE) {
      return;
    }
    Worker.once(
        NAME,
        FAILED,
        () -> {
          if (!closedWithin(REST_MS)) {
            film(films.fresh(1), snapshots);
          }
        });
  }

  private boolean closedWithin(int milliseconds) {
    try {
      return closed.await(milliseconds, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return true;
    }
  }

  /** Ends it early. */
  @Override
  public void close() {
    closed.countDown();
  }

  private void film(Film film, Supplier<SimSnapshot> snapshots) {
    for (int i = 0; i < PICTURES && closed.getCount() > 0; i++) {
      SimSnapshot snapshot = snapshots.get();
      if (filming(snapshot)) {
        return; // in earnest, and who waits for it shall have the processor
      }
      film.shoot(i == 0 ? snapshot : turned(snapshot, i * TURN), FORMAT);
      film.encode(i * FORMAT.period(), i % 4 == 0);
    }
  }

  private static boolean filming(SimSnapshot snapshot) {
    return snapshot.drones().stream().anyMatch(drone -> drone.state().video().on());
  }

  /**
   * A drone before the start of the default simulation, which itself would take longer to make than
   * it takes to paint the room.
   */
  private static SimSnapshot beforeTheStart() {
    SimConfig config = SimConfig.DEFAULT;
    DroneSetup setup = config.drones().get(0);
    Outlets outlets = setup.outlets();
    DroneSnapshot drone =
        new DroneSnapshot(
            new DroneModel(1, setup.start()).snapshot(SimTime.ZERO),
            new Link(Optional.empty(), outlets.statePort(), outlets.videoPort()),
            setup.product(),
            setup.start());
    return new SimSnapshot(
        SimTime.ZERO, new Clock(config.timeFactor(), false), config.arena(), List.of(drone));
  }

  /** The same with the first drone turned, and in the air, where it sees far. */
  private static SimSnapshot turned(SimSnapshot snapshot, double angle) {
    DroneSnapshot drone = snapshot.drones().get(0);
    Vec3 above = drone.start().position().withZ(1);
    Motion motion = Motion.restingAt(new Pose(above, Attitude.ofHeading(angle)));
    return snapshot.withDrones(List.of(drone.withState(drone.state().withMotion(motion))));
  }
}
