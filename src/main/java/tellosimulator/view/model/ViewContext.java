package tellosimulator.view.model;

import java.util.List;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.overlay.ContactLog;
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
 * @param lastCommand what the drones were told last
 * @param marks where the drones shall do it, and what they touched
 */
public record ViewContext(
    FxSimulation simulation,
    SimulatorActions actions,
    Language language,
    Pulse pulse,
    WindowVideo video,
    FxScenario scenario,
    LastCommand lastCommand,
    FxMarks marks) {

  /** Lets the window show at once what happens. */
  private record WakeOnEvent(Pulse pulse) implements SimListener {
    @Override
    public void event(SimEvent event) {
      pulse.wake();
    }
  }

  /** What views of the room need of it. */
  public SceneContext scene() {
    return new SceneContext(simulation, language, pulse, video, marks);
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
    SimulatorActions actions = new SimulatorActions(online);
    Pulse pulse =
        new Pulse(
            () -> {
              actions.collect();
              simulation.update(online.snapshot());
              scenario.update();
            },
            simulation::still);
    simulation.setIdle(pulse::idle);
    actions.onAnswered(pulse::wake);
    pulse.onBeat(nanos -> actions.deliver());
    LastCommand lastCommand = new LastCommand();
    online.listen(lastCommand);
    ContactLog contacts = new ContactLog();
    online.listen(contacts); // before it wakes the window, which shows what it has
    online.listen(new WakeOnEvent(pulse));
    pulse.onBeat(nanos -> video.advance());
    FxMarks marks = new FxMarks(scenario.progressProperty()::get, contacts::marks);
    return new ViewContext(
        simulation, actions, language, pulse, video, scenario, lastCommand, marks);
  }
}
