/**
 * What a drone does: commands in, targets for the physics out.
 *
 * <p>{@link tellosimulator.controller.DroneController} carries commands out; {@code Flight} goes
 * from maneuver to maneuver; {@code Autopilot} flies one {@code Maneuver} and says when it is over.
 * Each new maneuver is a class that implements {@code Maneuver}. All of it runs on the simulation
 * thread. The package imports {@code command}, {@code physics}, {@code sensor} and what these stand
 * on. Texts of the wire, sockets and the physics themselves are not its job.
 */
package tellosimulator.controller;
