/**
 * The program with a window.
 *
 * <p>{@link tellosimulator.view.app.Toolkit} starts JavaFX; {@link
 * tellosimulator.view.app.SimulatorApp} opens the stage, and opens and saves scenarios. What
 * belongs to one scenario is a {@code ScenarioSession} with its {@link
 * tellosimulator.view.app.SimulatorWindow}. All but the start is for the JavaFX thread. The package
 * stands on all others of the window; only {@code Main} imports it.
 */
package tellosimulator.view.app;
