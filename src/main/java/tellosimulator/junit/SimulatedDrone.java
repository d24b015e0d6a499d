package tellosimulator.junit;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Locale;
import tellosimulator.fault.Fault;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.model.DroneSpec;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig.StreamPorts;

/**
 * A drone of a {@link TelloSimulator}: its network addresses, the controls that a test has over it,
 * and its true state. A program under test sees only the network traffic.
 */
public final class SimulatedDrone {

  private final TelloSimulator simulator;
  private final int number;
  private final StreamPorts streamPorts;
  private final Journal journal;

  SimulatedDrone(TelloSimulator simulator, int number, StreamPorts streamPorts) {
    this.simulator = simulator;
    this.number = number;
    this.streamPorts = streamPorts;
    FlightMonitor monitor = simulator.monitor();
    this.journal = new Journal(simulator, () -> monitor.journal(number), toString());
  }

  /** Returns the number of the drone, from 1. */
  public int number() {
    return number;
  }

  /** Returns the address and port on which the drone receives commands. */
  public InetSocketAddress address() {
    return simulator.address(number);
  }

  /** Returns the IP address on which the drone receives commands, in numeric form. */
  public String host() {
    return address().getAddress().getHostAddress();
  }

  /** Returns the port on which the drone receives commands. */
  public int commandPort() {
    return address().getPort();
  }

  /** Returns the port on which the program under test receives the drone's state. */
  public int statePort() {
    return streamPorts.statePort();
  }

  /** Returns the port on which the program under test receives the drone's video. */
  public int videoPort() {
    return streamPorts.videoPort();
  }

  /**
   * Sets the charge of the drone's battery.
   *
   * @param percent 0 to 100
   * @throws IllegalArgumentException if the charge is outside this range
   */
  public void battery(double percent) {
    simulator.carryOut(new Control.SetBattery(number, percent));
  }

  /**
   * Moves the drone's start. A drone that stands on the ground moves with it. At its start, the
   * drone faces along the room's x axis.
   *
   * @param x along the room's depth, from the middle of the room [cm]
   * @param y to the left [cm]
   */
  public void placeAt(double x, double y) {
    placeAt(x, y, 0);
  }

  /**
   * Moves the drone's start. A drone that stands on the ground moves with it.
   *
   * @param x along the room's depth, from the middle of the room [cm]
   * @param y to the left [cm]
   * @param heading the direction of the drone's nose [degrees], clockwise seen from above; 0 is
   *     along the room's x axis
   * @throws IllegalArgumentException if the place is outside the room, or the heading is not from
   *     -360 to 360 degrees
   */
  public void placeAt(double x, double y, double heading) {
    TelloSimulation.checkAngle("heading", heading);
    Vec3 place = new Vec3(Frames.meters(x), Frames.meters(y), 0);
    if (!simulator.snapshot().room().contains(place, DroneSpec.COLLIDER)) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "x %.0f, y %.0f cm is not in the room, where %s should stand",
              x,
              y,
              this));
    }
    simulator.carryOut(new Control.SetStart(number, place, Frames.headingOfYaw(heading)));
  }

  /** Puts the drone back at its start, and releases it from its operator. */
  public void reset() {
    simulator.carryOut(new Control.Reset(number));
  }

  /** Switches the drone on or off. */
  public void power(boolean on) {
    simulator.carryOut(new Control.Power(number, on));
  }

  /** Returns the drone's current true state. It is read from the simulation, not from the wire. */
  public DroneTruth truth() {
    simulator.settle();
    return simulator.monitor().truth(number);
  }

  /** Returns the texts that were sent to the drone, and its replies. */
  public Journal journal() {
    return journal;
  }

  /**
   * Creates a program that will fly this drone, such as {@code program("python3", "fly.py",
   * "{host}", "{commandPort}")}.
   *
   * @param command the program and its arguments; the placeholders {@code {host}}, {@code
   *     {commandPort}}, {@code {statePort}} and {@code {videoPort}} are replaced with the values of
   *     this drone
   * @return the program, not started yet; a test that never {@linkplain OperatorProgram#run runs}
   *     it fails
   * @throws IllegalArgumentException if a word is any other placeholder
   */
  public OperatorProgram program(String... command) {
    if (command.length == 0) {
      throw new IllegalArgumentException("command is empty, but must name a program");
    }
    OperatorProgram program = new OperatorProgram(List.of(command), this, simulator::started);
    simulator.named(program);
    return program;
  }

  /** Waits until falling drones have reached the ground. */
  void awaitFalls() {
    simulator.awaitFalls();
  }

  /** Returns the faults that currently affect the drone, one line each. */
  List<String> faults() {
    return simulator.snapshot().drones().get(number - 1).faults().faults().stream()
        .map(Fault::toString)
        .toList();
  }

  /** Returns the names of the gates in the room. */
  List<String> gates() {
    return simulator.monitor().gates();
  }

  @Override
  public String toString() {
    return "drone " + number;
  }
}
