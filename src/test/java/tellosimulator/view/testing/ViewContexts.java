package tellosimulator.view.testing;

import java.lang.reflect.Proxy;
import java.util.List;
import tellosimulator.goal.GoalWatch;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenario.EditedScenario;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot.DroneSnapshot;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.WindowVideo;

/** Contexts of views that are tested without the rest of the program. */
public final class ViewContexts {

  /** Actions on scenarios without any effect. */
  public static final ScenarioActions NO_SCENARIOS =
      (ScenarioActions)
          Proxy.newProxyInstance(
              ScenarioActions.class.getClassLoader(),
              new Class<?>[] {ScenarioActions.class},
              (proxy, method, arguments) ->
                  method.getReturnType() == boolean.class ? Boolean.FALSE : null);

  private ViewContexts() {}

  /** Returns the context of a window on a running simulation without a challenge. */
  public static ViewContext of(OnlineSimulation online, Language language, WindowVideo video) {
    List<DroneSetup> drones =
        SimConfig.alike(online.snapshot().drones().stream().map(DroneSnapshot::start).toList());
    Scenario scenario = Scenario.of(SimConfig.DEFAULT.withDrones(drones));
    GoalWatch goals = new GoalWatch(scenario.challenge(), news -> {});
    EditedScenario plain = EditedScenario.of(OpenedScenario.once(scenario));
    return ViewContext.of(
        online, language, video, new FxScenario(plain, goals, goals::ask, NO_SCENARIOS));
  }
}
