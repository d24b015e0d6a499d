/**
 * The panels at the left and right of the window, and the controls that they are made of.
 *
 * <p>{@link tellosimulator.view.controls.SimulatorControls} shows the flight and sets the room;
 * {@link tellosimulator.view.controls.NetworkControls} is the power switch and the network. They
 * bind one way to the mirror of the simulation and send one {@code Control} for each thing that a
 * person does. Instruments are shapes whose looks are in {@code controls.css}; each changes only
 * when the change can be seen. Everything is for the JavaFX thread. Where the panels stand in the
 * window is not their job.
 */
package tellosimulator.view.controls;
