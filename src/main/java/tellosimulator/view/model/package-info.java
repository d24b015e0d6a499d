/**
 * The data and the actions of the window's views.
 *
 * <p>{@link tellosimulator.view.model.FxSimulation}, {@link tellosimulator.view.model.FxDroneModel}
 * and {@link tellosimulator.view.model.FxScenario} mirror the simulation's snapshots at each tick
 * of the {@link tellosimulator.view.model.UiTicker}; all views bind to them unidirectionally. The
 * user's actions go through {@link tellosimulator.view.model.SimulatorActions} and {@link
 * tellosimulator.view.model.ScenarioActions}. Each view is built with a {@link
 * tellosimulator.view.model.ViewContext}. Unless a class says otherwise, it is confined to the
 * JavaFX thread. The package contains no nodes.
 */
package tellosimulator.view.model;
