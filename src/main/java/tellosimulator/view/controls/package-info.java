/**
 * The panels at the left and right of the window, and their controls.
 *
 * <p>{@link tellosimulator.view.controls.SimulatorControls} shows the flight and changes the room;
 * {@link tellosimulator.view.controls.NetworkControls} contains the power switch and the controls
 * for the network. Both panels bind unidirectionally to the model of the simulation and send one
 * {@code Control} for each action of the user. Instruments are shapes styled in {@code
 * controls.css}. Each instrument is updated only if the change is visible. Everything is confined
 * to the JavaFX thread. The package does not position the panels in the window.
 */
package tellosimulator.view.controls;
