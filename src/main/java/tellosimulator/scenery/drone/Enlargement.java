package tellosimulator.scenery.drone;

import tellosimulator.math.Vec3;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;

/**
 * The factor by which a drone is enlarged for people, so that it is recognisable from the far side
 * of a room. The drone is scaled about its feet, so its displayed position stays correct.
 */
public final class Enlargement {

  /**
   * Displayed width of a lone drone, as a fraction of its distance from the viewer. Decided: by
   * eye; about 60 pixels in a window of 1280 × 800 pixels.
   */
  private static final double SHARE = 0.06;

  /**
   * Maximum factor. Decided: the drone still fits through a gate of 60 cm with clearance on both
   * sides.
   */
  private static final double MOST = 3;

  /**
   * Exponent to which the number of drones is raised to get the relative size of each drone's
   * marker. Decided: the markers of twenty drones in rows hardly overlap.
   */
  private static final double CROWDED = -1.0 / 6;

  private Enlargement() {}

  /**
   * Returns the factor for a drone seen from a given position, or 1 if the drone is large enough
   * without enlargement.
   *
   * @param count number of drones
   * @param eye position of the viewer in the room frame
   */
  public static double of(DroneSnapshot drone, int count, Vec3 eye) {
    double distance = eye.distanceTo(drone.state().motion().position());
    double wanted = SHARE * crowded(count) * distance / BodyMesh.SPAN;
    return Math.max(1, Math.min(MOST, wanted));
  }

  /**
   * Returns the size of a drone's marker among several drones, relative to the size of a lone
   * drone's marker.
   */
  public static double crowded(int count) {
    return StrictMath.pow(count, CROWDED);
  }
}
