package tellosimulator.view.world;

import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.FxDroneModel;
import tellosimulator.view.FxSimulation;
import tellosimulator.world.Room;

/** The camera in the nose of the selected drone: it pitches and rolls with it. */
public final class DroneCamera {

  private final FxSimulation simulation;
  private final DroneOptics optics;

  DroneCamera(FxSimulation simulation, DroneOptics optics) {
    this.simulation = simulation;
    this.optics = optics;
  }

  /** What it is like. */
  DroneOptics optics() {
    return optics;
  }

  /** Where it is and how it looks, room frame; it looks along its x axis. */
  public Pose pose() {
    FxDroneModel drone = simulation.selected();
    return optics.nose(drone.poseProperty().get());
  }

  /** Farther things are not in the picture [m]: nothing in the room is. */
  double far() {
    Room room = simulation.roomProperty().get();
    return 1 + new Vec3(room.depth(), room.width(), room.height()).norm();
  }
}
