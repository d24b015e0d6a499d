package tellosimulator.view.world;

import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxSimulation;
import tellosimulator.world.Room;

/** The camera in the nose of the selected drone: it pitches and rolls with it. */
public final class DroneCamera {

  /** Size of its picture in pixels. Documented: 960 by 720 (fact sheet 6.1). */
  public static final int WIDTH = 960;

  public static final int HEIGHT = 720;

  /**
   * Field of view from left to right [degrees]. Measured: 55, from calibrated pictures of the
   * stream of several drones; the 82.6 of the manual do not describe the stream.
   */
  public static final double FIELD_OF_VIEW_DEG = 55;

  /**
   * How far it looks down [rad]. Measured: about 15 degrees, the only concrete figure, from a model
   * of the drone for another simulator; other sources assume 0.
   */
  public static final double TILT = Math.toRadians(15);

  /**
   * Where it is, body frame [m]. Measured: 3.5 cm ahead of the middle (from the same model); the
   * height is that of the lens.
   */
  private static final Vec3 MOUNT = new Vec3(0.035, 0, 0.0185);

  /**
   * Nearer things are not in the picture [m]. Decided: nearer than the floor is to the lower edge
   * of the picture while the drone stands, 1.85 cm / sin 36° = 3.1 cm.
   */
  static final double NEAR = 0.02;

  private static final Attitude DOWN = new Attitude(Math.cos(TILT / 2), 0, Math.sin(TILT / 2), 0);

  private final FxSimulation simulation;

  DroneCamera(FxSimulation simulation) {
    this.simulation = simulation;
  }

  /** Where it is and how it looks, room frame; it looks along its x axis. */
  public Pose pose() {
    FxDroneModel drone = simulation.selected();
    return pose(drone.poseProperty().get());
  }

  /** The camera's pose on a drone. */
  static Pose pose(Pose drone) {
    Attitude attitude = drone.attitude();
    return new Pose(drone.position().plus(attitude.toRoom(MOUNT)), attitude.after(DOWN));
  }

  /** Farther things are not in the picture [m]: nothing in the room is. */
  double far() {
    Room room = simulation.roomProperty().get();
    return 1 + new Vec3(room.depth(), room.width(), room.height()).norm();
  }
}
