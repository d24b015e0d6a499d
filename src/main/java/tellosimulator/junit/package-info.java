/**
 * The test kit: simulated drones for unit tests of programs that fly drones. {@link
 * tellosimulator.junit.TelloTest} and {@link tellosimulator.junit.TelloSimulatorExtension} start a
 * simulator for JUnit; {@link tellosimulator.junit.TelloSimulator} is the same without any
 * framework. Tests talk to a drone over UDP, and look at what really happened through {@link
 * tellosimulator.junit.SimulatedDrone}, of which nothing is on the wire.
 *
 * <p>Lengths are centimetres, angles degrees, and times seconds of the simulation, as programs know
 * them from the drone. All types are for any thread unless they say otherwise. JUnit and AssertJ
 * are optional: only what their names are in the name of needs them.
 */
package tellosimulator.junit;
