package tellosimulator.view.plan;

import java.util.ArrayList;
import java.util.List;
import tellosimulator.goal.Challenge;
import tellosimulator.math.Pose;
import tellosimulator.scenario.DroneOrigin;
import tellosimulator.scenario.EditedScenario;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.PlannedDrone;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.SimConfig;
import tellosimulator.world.Arena;

/** Floor plans with default drones. */
final class FloorPlans {

  private FloorPlans() {}

  /** Returns a plan without goals. */
  static FloorPlan of(Arena arena, List<Pose> starts) {
    Scenario scenario = Scenario.of(SimConfig.DEFAULT.withDrones(SimConfig.alike(starts)));
    List<DroneOrigin> origins = EditedScenario.of(OpenedScenario.once(scenario)).origins();
    List<PlannedDrone> drones = new ArrayList<>();
    for (Pose start : starts) {
      drones.add(new PlannedDrone(origins.get(drones.size()), start));
    }
    return new FloorPlan(arena, drones, Challenge.NONE);
  }
}
