package tellosimulator.video;

import java.util.List;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.Motion;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.time.Threads;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.Encoders;

/**
 * Films and encodes pictures for nobody, on a thread of its own, so that the Java machine has
 * compiled what it takes, and what there is to see is painted, when an operator asks for the first
 * picture. Changes nothing. For any thread.
 */
public final class WarmUp implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(WarmUp.class);

  /** How many pictures. Measured: after these a picture takes hardly longer than after many. */
  private static final int PICTURES = 60;

  /**
   * How far the camera turns from picture to picture [rad]. Decided: as a drone at 60 degrees/s.
   */
  private static final double TURN = Math.toRadians(2);

  private final Supplier<FrameSource> sources;
  private final Encoders encoders;
  private volatile Supplier<SimSnapshot> snapshots = WarmUp::defaultSnapshot;
  private volatile boolean unneeded;
  private boolean begun;

  /**
   * Does nothing before {@link #begin}.
   *
   * @param sources of which it takes one
   */
  public WarmUp(Supplier<FrameSource> sources, Encoders encoders) {
    this.sources = sources;
    this.encoders = encoders;
  }

  /**
   * Begins, unless it has. Films the first drone of the default simulation until it has another.
   */
  public synchronized void begin() {
    if (!begun) {
      begun = true;
      Threads.start("video-warm-up", this::run);
    }
  }

  /**
   * From now on films the first drone of this simulation.
   *
   * @param newSnapshots the newest one
   */
  public void film(Supplier<SimSnapshot> newSnapshots) {
    snapshots = newSnapshots;
  }

  /** Ends it early. */
  @Override
  public void close() {
    unneeded = true;
  }

  private void run() {
    Film film = new Film(1, sources.get(), encoders);
    VideoFormat format = VideoFormat.of(VideoSettings.DEFAULT);
    try {
      for (int i = 0; i < PICTURES && !unneeded; i++) {
        SimSnapshot snapshot = snapshots.get();
        if (filming(snapshot)) {
          return; // in earnest, and who waits for it shall have the processor
        }
        film.shoot(turned(snapshot, i * TURN), format);
        film.encode(i % 4 == 0);
      }
    } catch (RuntimeException e) {
      LOG.error("The first pictures could not be made; please report this: {}", e.toString(), e);
    }
  }

  private static boolean filming(SimSnapshot snapshot) {
    return snapshot.drones().stream().anyMatch(drone -> drone.state().video().on());
  }

  private static SimSnapshot defaultSnapshot() {
    return new Simulation(SimConfig.DEFAULT, drone -> (peer, text) -> {}, report -> {}, List.of())
        .snapshot();
  }

  /** The same with the first drone turned, and in the air. */
  private static SimSnapshot turned(SimSnapshot snapshot, double angle) {
    DroneSnapshot drone = snapshot.drones().get(0);
    Vec3 above = drone.start().position().withZ(1);
    Motion motion = Motion.restingAt(new Pose(above, Attitude.ofHeading(angle)));
    return snapshot.withDrones(List.of(drone.withState(drone.state().withMotion(motion))));
  }
}
