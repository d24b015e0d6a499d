package tellosimulator.view;

import tellosimulator.network.OnlineSimulation;
import tellosimulator.view.text.Language;

/**
 * What each view is built with.
 *
 * @param simulation what it shows
 * @param actions what it can do
 * @param language in which it speaks
 * @param pulse when it moves on
 */
public record ViewContext(
    FxSimulation simulation, SimulatorActions actions, Language language, Pulse pulse) {

  /** The context of a window on a running simulation. */
  public static ViewContext of(OnlineSimulation online, Language language) {
    FxSimulation simulation = new FxSimulation(online.snapshot());
    Pulse pulse = new Pulse(() -> simulation.update(online.snapshot()));
    return new ViewContext(simulation, new SimulatorActions(online), language, pulse);
  }
}
