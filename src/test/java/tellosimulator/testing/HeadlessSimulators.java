package tellosimulator.testing;

import java.util.OptionalInt;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.video.camera.DroneOptics;

/** Creates simulators without a window. */
public final class HeadlessSimulators {

  private HeadlessSimulators() {}

  /** Returns a simulator of a scenario whose drones listen at the given addresses. */
  public static HeadlessSimulator of(Scenario scenario, AddressPlan plan) {
    return new HeadlessSimulator(
        OpenedScenario.once(scenario),
        new HeadlessSimulator.Rules(
            any -> any,
            any -> plan,
            OptionalInt.empty(),
            new SoftwareCameras(DroneOptics.DEFAULT)));
  }
}
