package tellosimulator.cli;

import tellosimulator.network.AddressPlan;
import tellosimulator.scenario.OpenedScenario;

/**
 * What is to be run, once all options are known to fit together.
 *
 * @param scenario with what the options say about it
 * @param addresses where its drones listen
 */
public record Launch(OpenedScenario scenario, AddressPlan addresses) {}
