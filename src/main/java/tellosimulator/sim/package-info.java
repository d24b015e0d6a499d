/**
 * The simulation as a whole: drones in a room, advanced in fixed steps by one thread.
 *
 * <p>{@link tellosimulator.sim.Simulation} is the core. {@link tellosimulator.sim.SimulationLoop}
 * runs it on its own thread, paced by a clock; tests call its steps directly. Commands and controls
 * enter through one inbox, from any thread. Snapshots and events are the output. The package
 * imports {@code controller} and the packages below it. It does not use sockets, files or windows.
 */
package tellosimulator.sim;
