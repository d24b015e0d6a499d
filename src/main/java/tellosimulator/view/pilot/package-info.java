/**
 * The controls for flying without an operator program.
 *
 * <p>{@link tellosimulator.view.pilot.PilotControls} contains the buttons. {@link
 * tellosimulator.view.pilot.DemoFlight} flies a route or a tour by itself, and {@link
 * tellosimulator.view.pilot.KeyboardSteering} lets the user fly with the keyboard. Both send
 * commands to the drone's UDP command port, as any operator program does, so the log shows each
 * command. Everything runs on the JavaFX thread at the ticks of {@link
 * tellosimulator.view.model.UiTicker}. Sockets are polled without blocking, so no other threads are
 * needed. Controls that bypass the network, such as the power switch, use {@link
 * tellosimulator.view.model.SimulatorActions}.
 */
package tellosimulator.view.pilot;
