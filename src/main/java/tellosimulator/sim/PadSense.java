package tellosimulator.sim;

import java.util.List;
import tellosimulator.model.DroneModel;
import tellosimulator.model.PadSighting;
import tellosimulator.model.Perception;
import tellosimulator.sensor.PadDetector;
import tellosimulator.time.SimTime;

/** Updates a drone's perception of mission pads. Confined to the simulation thread. */
final class PadSense {

  private final PadDetector detector = new PadDetector();

  /**
   * Detects mission pads at the end of a step, if a detection is due.
   *
   * @param model receives the detected pads
   * @param blind whether a fault prevents detection
   */
  void sense(DroneModel model, SimTime now, boolean blind, CollisionWorld collisionWorld) {
    Perception before = model.perception();
    if (blind) {
      if (!before.pads().isEmpty()) {
        model.setPerception(new Perception(before.padMode(), true, List.of()));
      }
    } else if (PadDetector.looksAt(now, before.padMode())) {
      PadSighting.Moment moment = new PadSighting.Moment(now, model.motion().pose());
      model.setPerception(
          detector.look(moment, before, collisionWorld.cards(), collisionWorld::free));
    }
  }
}
