/**
 * What the views of the window show, and what they can do.
 *
 * <p>{@link tellosimulator.view.model.FxSimulation}, {@link tellosimulator.view.model.FxDroneModel}
 * and {@link tellosimulator.view.model.FxScenario} mirror the simulation's snapshots once a {@link
 * tellosimulator.view.model.Pulse}; all views bind to them one way. What a person does goes through
 * {@link tellosimulator.view.model.SimulatorActions} and {@link
 * tellosimulator.view.model.ScenarioActions}. Each view is built with a {@link
 * tellosimulator.view.model.ViewContext}. Everything is for the JavaFX thread. Nodes are not its
 * job.
 */
package tellosimulator.view.model;
