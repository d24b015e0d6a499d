package tellosimulator.view;

import java.util.List;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.WindowVideo;

/**
 * What each view is built with.
 *
 * @param simulation what it shows
 * @param actions what it can do
 * @param language in which it speaks
 * @param pulse when it moves on
 * @param video what the drones film
 * @param scenario what the drones shall do
 */
public record ViewContext(
    FxSimulation simulation,
    SimulatorActions actions,
    Language language,
    Pulse pulse,
    WindowVideo video,
    FxScenario scenario) {

  /** Lets the window show at once what happens. */
  private record Stirring(Pulse pulse) implements SimListener {
    @Override
    public void event(SimEvent event) {
      pulse.stir();
    }
  }

  /** The context of a window on a running simulation that nobody asks for anything. */
  public static ViewContext of(OnlineSimulation online, Language language, WindowVideo video) {
    List<DroneSetup> drones =
        SimConfig.alike(online.snapshot().drones().stream().map(DroneSnapshot::start).toList());
    return of(
        online,
        language,
        video,
        FxScenario.none(Scenario.of(SimConfig.DEFAULT.withDrones(drones))));
  }

  /** The context of a window on a running simulation. */
  public static ViewContext of(
      OnlineSimulation online, Language language, WindowVideo video, FxScenario scenario) {
    FxSimulation simulation = new FxSimulation(online.snapshot());
    Pulse pulse =
        new Pulse(
            () -> {
              simulation.update(online.snapshot());
              scenario.update();
            },
            simulation::still);
    simulation.dozeWith(pulse::idle);
    online.listen(new Stirring(pulse));
    pulse.onBeat(nanos -> video.advance());
    return new ViewContext(
        simulation, new SimulatorActions(online), language, pulse, video, scenario);
  }
}
