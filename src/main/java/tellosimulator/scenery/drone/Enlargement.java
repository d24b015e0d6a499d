package tellosimulator.scenery.drone;

import tellosimulator.math.Vec3;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * How much larger than life a drone is drawn for people, so that it can be told from the far side
 * of a room. It grows about its feet, so that where it stands and flies stays true.
 */
public final class Enlargement {

  /**
   * Width of a lone drone in the picture, as a share of its distance. Decided: by eye; about 60
   * pixels in a window of 1280 × 800 pixels.
   */
  private static final double SHARE = 0.06;

  /** The largest factor. Decided: it still fits through a gate of 60 cm with air on both sides. */
  private static final double MOST = 3;

  /** By which power of their number marks shrink. Decided: twenty in rows hardly meet. */
  private static final double CROWDED = -1.0 / 6;

  private Enlargement() {}

  /**
   * The factor for a drone that is seen from a place; 1 where it is large enough by itself.
   *
   * @param count how many drones there are
   * @param eye room frame
   */
  public static double of(DroneSnapshot drone, int count, Vec3 eye) {
    double distance = eye.distanceTo(drone.state().motion().position());
    double wanted = SHARE * crowded(count) * distance / BodyMesh.SPAN;
    return Math.max(1, Math.min(MOST, wanted));
  }

  /** By how much that which marks each of several drones is smaller than that of a lone one. */
  public static double crowded(int count) {
    return StrictMath.pow(count, CROWDED);
  }
}
