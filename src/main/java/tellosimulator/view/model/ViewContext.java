package tellosimulator.view.model;

import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenery.overlay.ContactLog;
import tellosimulator.sim.LastCommand;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimListener;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.WindowVideo;

/**
 * The context with which each view is built.
 *
 * @param simulation the simulation that the view shows
 * @param actions the actions on the simulation
 * @param language the language of the texts
 * @param ticker notifies the view when to update
 * @param video the video of the drones
 * @param scenario the scenario with its challenge
 * @param lastCommand the latest command that was sent to a drone
 * @param marks the goals and contacts that are drawn over the room
 */
public record ViewContext(
    FxSimulation simulation,
    SimulatorActions actions,
    Language language,
    UiTicker ticker,
    WindowVideo video,
    FxScenario scenario,
    LastCommand lastCommand,
    FxOverlayItems marks) {

  /** Wakes the window on each event, so that the window shows the event without delay. */
  private record WakeOnEvent(UiTicker ticker) implements SimListener {
    @Override
    public void event(SimEvent event) {
      ticker.wake();
    }
  }

  /** Returns the part of the context that views of the room need. */
  public SceneContext scene() {
    return new SceneContext(simulation, language, ticker, video, marks);
  }

  /** Returns the context of a window that shows a running simulation. */
  public static ViewContext of(
      OnlineSimulation online, Language language, WindowVideo video, FxScenario scenario) {
    FxSimulation simulation = new FxSimulation(online.snapshot());
    SimulatorActions actions = new SimulatorActions(online);
    UiTicker ticker =
        new UiTicker(
            () -> {
              actions.collect();
              simulation.update(online.snapshot());
              scenario.update();
            },
            simulation::still);
    simulation.setIdle(ticker::idle);
    actions.onAnswered(ticker::wake);
    ticker.onTick(nanos -> actions.deliver());
    LastCommand lastCommand = new LastCommand();
    online.listen(lastCommand);
    ContactLog contacts = new ContactLog();
    online.listen(contacts); // before WakeOnEvent, which makes the window show contacts
    online.listen(new WakeOnEvent(ticker));
    ticker.onTick(nanos -> video.advance());
    FxOverlayItems marks = new FxOverlayItems(scenario.progressProperty()::get, contacts::marks);
    return new ViewContext(
        simulation, actions, language, ticker, video, scenario, lastCommand, marks);
  }
}
