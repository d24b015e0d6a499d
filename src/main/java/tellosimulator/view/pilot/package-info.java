/**
 * Flying without an operator program.
 *
 * <p>{@link tellosimulator.view.pilot.PilotControls} are the buttons; behind them {@link
 * tellosimulator.view.pilot.DemoFlight} flies a tour by itself, and {@link
 * tellosimulator.view.pilot.KeyboardSteering} flies by keyboard. Both send commands to the drone's
 * real port, as any operator program does, so the log shows each of them. Everything runs on the
 * JavaFX thread at the beat of {@link tellosimulator.view.model.Pulse}: sockets are asked, never
 * waited for, so there are no threads. Controls that go past the network, such as the power switch,
 * are {@link tellosimulator.view.model.SimulatorActions}.
 */
package tellosimulator.view.pilot;
