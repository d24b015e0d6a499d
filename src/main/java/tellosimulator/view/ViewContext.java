package tellosimulator.view;

import tellosimulator.network.OnlineSimulation;
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
 */
public record ViewContext(
    FxSimulation simulation,
    SimulatorActions actions,
    Language language,
    Pulse pulse,
    WindowVideo video) {

  /** The context of a window on a running simulation. */
  public static ViewContext of(OnlineSimulation online, Language language, WindowVideo video) {
    FxSimulation simulation = new FxSimulation(online.snapshot());
    Pulse pulse = new Pulse(() -> simulation.update(online.snapshot()));
    pulse.onBeat(nanos -> video.advance());
    return new ViewContext(simulation, new SimulatorActions(online), language, pulse, video);
  }
}
