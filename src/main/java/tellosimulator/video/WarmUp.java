package tellosimulator.video;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.model.Motion;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * Films and encodes pictures for nobody, so that the Java machine has compiled what it takes when
 * an operator asks for the first one. Changes nothing. For one thread.
 */
final class WarmUp {

  private static final Logger LOG = LoggerFactory.getLogger(WarmUp.class);

  /** How many pictures. Measured: after these a picture takes hardly longer than after many. */
  private static final int PICTURES = 60;

  /**
   * How far the camera turns from picture to picture [rad]. Decided: as a drone at 60 degrees/s.
   */
  private static final double TURN = Math.toRadians(2);

  private WarmUp() {}

  /**
   * Takes its time.
   *
   * @param film of the first drone, used for nothing else meanwhile
   * @param unneeded ends it early
   */
  static void run(Film film, SimSnapshot snapshot, BooleanSupplier unneeded) {
    VideoFormat format = VideoFormat.of(VideoSettings.DEFAULT);
    try {
      for (int i = 0; i < PICTURES && !unneeded.getAsBoolean(); i++) {
        film.shoot(turned(snapshot, i * TURN), format);
        film.encode(i % 4 == 0);
      }
    } catch (RuntimeException e) {
      LOG.error("The first pictures could not be made; please report this: {}", e.toString(), e);
    }
  }

  /** The same with the first drone turned, and in the air. */
  private static SimSnapshot turned(SimSnapshot snapshot, double angle) {
    DroneSnapshot drone = snapshot.drones().get(0);
    Vec3 above = drone.start().position().withZ(1);
    Motion motion = Motion.restingAt(new Pose(above, Attitude.ofHeading(angle)));
    return snapshot.withDrones(List.of(drone.withState(drone.state().withMotion(motion))));
  }
}
