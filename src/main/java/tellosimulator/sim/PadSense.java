package tellosimulator.sim;

import java.util.List;
import tellosimulator.model.DroneModel;
import tellosimulator.model.PadSighting;
import tellosimulator.model.Perception;
import tellosimulator.sensor.PadDetector;
import tellosimulator.time.SimTime;

/** Updates what a drone sees of mission pads. For the simulation thread. */
final class PadSense {

  private final PadDetector detector = new PadDetector();

  /**
   * Looks for pads at the end of a step, if it is time to.
   *
   * @param model takes what is seen
   * @param blind whether a fault keeps it from seeing any
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
