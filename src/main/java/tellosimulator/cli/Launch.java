package tellosimulator.cli;

import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.OpenedScenario;

/**
 * A simulation to be run. All options have been checked.
 *
 * @param scenario the scenario with all options applied
 * @param addresses the listen addresses of the drones
 */
public record Launch(OpenedScenario scenario, AddressPlan addresses) {}
