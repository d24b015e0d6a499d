package tellosimulator.view.world;

import tellosimulator.math.Pose;
import tellosimulator.view.FxDroneModel;

/** Notices when a drone is put to its start: by a reset, or because the start was moved. */
final class FollowsStart {

  private final FxDroneModel drone;
  private Pose last;

  FollowsStart(FxDroneModel drone) {
    this.drone = drone;
    last = drone.poseProperty().get();
  }

  /** Whether it was put there since the last call. */
  boolean wasReset() {
    Pose now = drone.poseProperty().get();
    boolean reset = !now.equals(last) && now.equals(drone.startProperty().get());
    last = now;
    return reset;
  }
}
