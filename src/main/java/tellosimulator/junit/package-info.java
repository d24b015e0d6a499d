/**
 * The test kit: simulated drones for unit tests of programs that fly drones. {@link
 * tellosimulator.junit.TelloTest} and {@link tellosimulator.junit.TelloSimulatorExtension} start a
 * simulator for JUnit; {@link tellosimulator.junit.TelloSimulator} works without any framework.
 * Programs under test talk to a drone over UDP. Tests observe its true state through {@link
 * tellosimulator.junit.SimulatedDrone}, which reads it from the simulation, not from the wire.
 *
 * <p>Lengths are in centimetres and angles in degrees, as in the drone's own protocol; times are in
 * simulated seconds. All types are thread-safe unless documented otherwise. JUnit and AssertJ are
 * optional: {@code TelloTest} and {@code TelloSimulatorExtension} need JUnit; {@code
 * TelloAssertions} and {@code DroneAssert} need AssertJ.
 */
package tellosimulator.junit;
