/**
 * The simulation as a whole: drones in a room, moved on in fixed steps by one thread.
 *
 * <p>{@link tellosimulator.sim.Simulation} is the core; {@link tellosimulator.sim.SimulationLoop}
 * gives it a thread and a pace, tests step it instead. Commands and controls come in through one
 * inbox from any thread; snapshots and events go out. The package imports {@code controller} and
 * what that stands on. Sockets, files and windows are not its job.
 */
package tellosimulator.sim;
