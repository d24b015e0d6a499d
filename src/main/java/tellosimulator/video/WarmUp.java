package tellosimulator.video;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.command.Link;
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
import tellosimulator.time.Threads;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.Encoders;

/**
 * Films and encodes pictures for nobody, on a thread of its own, so that the Java machine has
 * compiled what it takes, and what there is to see is painted, when an operator asks for the first
 * picture. Changes nothing. For any thread.
 */
public final class WarmUp implements AutoCloseable {

  private static final String NAME = "video-warm-up";

  /** How many pictures. Measured: after these a picture takes hardly longer than after many. */
  private static final int PICTURES = 60;

  /**
   * How many pictures before there is a simulation. Measured: one paints the room and loads all
   * code; more of them only keep the program from starting where there are two processors.
   */
  private static final int EARLY_PICTURES = 1;

  /**
   * How far the camera turns from picture to picture [rad]. Decided: as a drone at 60 degrees/s.
   */
  private static final double TURN = Math.toRadians(2);

  /**
   * How long it rests before it films a simulation [ms]. Decided: longer than a program takes that
   * asks for pictures right after the start, which shall have the processors to itself.
   */
  private static final int REST_MS = 400;

  /** Longest time for which the start of the program waits for the early pictures [ms]. Decided. */
  private static final int PATIENCE_MS = 300;

  private final Supplier<FrameSource> sources;
  private final Encoders encoders;
  private final CountDownLatch early = new CountDownLatch(1);
  private final CountDownLatch closed = new CountDownLatch(1);

  /**
   * Does nothing yet.
   *
   * @param sources of which it takes one for each of its threads
   */
  public WarmUp(Supplier<FrameSource> sources, Encoders encoders) {
    this.sources = sources;
    this.encoders = encoders;
  }

  /**
   * Films what a drone sees from the floor of the default room, as the first picture will be; no
   * simulation has to be there yet.
   */
  public void beginEarly() {
    Threads.start(
        NAME,
        () -> {
          film(WarmUp::beforeTheStart, EARLY_PICTURES);
          early.countDown();
        });
  }

  /**
   * Waits until the pictures of {@link #beginEarly} are there, but no longer than a moment; only
   * after that is a program ready to film.
   */
  public void awaitEarly() throws InterruptedException {
    if (!early.await(PATIENCE_MS, TimeUnit.MILLISECONDS)) {
      log().debug("The first pictures are not yet there");
    }
  }

  /**
   * Films the first drone of a simulation, a moment later.
   *
   * @param snapshots the newest one
   */
  public void begin(Supplier<SimSnapshot> snapshots) {
    Threads.start(
        NAME,
        () -> {
          if (!closedWithin(REST_MS)) {
            film(snapshots, PICTURES);
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

  private void film(Supplier<SimSnapshot> snapshots, int pictures) {
    try {
      Film film = new Film(1, sources.get(), encoders);
      VideoFormat format = VideoFormat.of(VideoSettings.DEFAULT);
      for (int i = 0; i < pictures && closed.getCount() > 0; i++) {
        SimSnapshot snapshot = snapshots.get();
        if (filming(snapshot)) {
          return; // in earnest, and who waits for it shall have the processor
        }
        film.shoot(i == 0 ? snapshot : turned(snapshot, i * TURN), format);
        film.encode(i * format.period(), i % 4 == 0);
      }
    } catch (RuntimeException e) {
      log().error("The first pictures could not be made; please report this: {}", e.toString(), e);
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

  /** Not a constant: logging takes long to start, and the first picture does not wait for it. */
  private static Logger log() {
    return LoggerFactory.getLogger(WarmUp.class);
  }
}
