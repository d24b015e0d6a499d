/**
 * The window.
 *
 * <p>{@link tellosimulator.view.SimulatorApp} opens it. {@link tellosimulator.view.FxSimulation}
 * and {@link tellosimulator.view.FxDroneModel} mirror the simulation's snapshots once a pulse; all
 * views bind to them one way. What a person does goes through {@link
 * tellosimulator.view.SimulatorActions}. Everything runs on the JavaFX thread. The packages below:
 * {@code layout} arranges, {@code controls} shows and sets numbers, {@code world} and {@code drone}
 * are the 3D scene, {@code log} the log, {@code pilot} flies drones over UDP, {@code settings}
 * remembers. Only {@code Main} imports this package, and only here is JavaFX. Flying is not its
 * job.
 */
package tellosimulator.view;
