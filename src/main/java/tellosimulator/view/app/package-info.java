/**
 * The simulator program with a window.
 *
 * <p>{@link tellosimulator.view.app.Toolkit} starts JavaFX; {@link
 * tellosimulator.view.app.SimulatorApp} opens the stage, and opens and saves scenarios. A {@code
 * ScenarioSession} holds the state of one scenario, and a {@link
 * tellosimulator.view.app.SimulatorWindow} displays the scenario. Everything except the startup is
 * confined to the JavaFX thread. This package may import all other packages of the window. Only
 * {@code Main} imports this package.
 */
package tellosimulator.view.app;
