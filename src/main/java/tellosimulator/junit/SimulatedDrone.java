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
 * A drone of a {@link TelloSimulator}: where programs reach it, what a test may do to it, and what
 * it really does. Programs only see its wire.
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

  /** From 1. */
  public int number() {
    return number;
  }

  /** Where it takes commands. */
  public InetSocketAddress address() {
    return simulator.address(number);
  }

  /** The address at which it takes commands, in digits. */
  public String host() {
    return address().getAddress().getHostAddress();
  }

  /** The port at which it takes commands. */
  public int commandPort() {
    return address().getPort();
  }

  /** The port of the program under test to which it sends its state. */
  public int statePort() {
    return streamPorts.statePort();
  }

  /** The port of the program under test to which it sends its video. */
  public int videoPort() {
    return streamPorts.videoPort();
  }

  /**
   * Charges or drains its battery.
   *
   * @param percent 0 to 100
   * @throws IllegalArgumentException if it is not
   */
  public void battery(double percent) {
    simulator.carryOut(new Control.SetBattery(number, percent));
  }

  /**
   * Puts it elsewhere on the floor, if it stands, and its start in any case; it looks along the
   * room's x.
   *
   * @param x along the room's depth, from its middle [cm]
   * @param y to the left [cm]
   */
  public void placeAt(double x, double y) {
    placeAt(x, y, 0);
  }

  /**
   * The same, looking elsewhere.
   *
   * @param heading where its nose points [degrees], clockwise seen from above, 0 along the room's x
   * @throws IllegalArgumentException if the place is not in the room, or the heading not from -360
   *     to 360 degrees
   */
  public void placeAt(double x, double y, double heading) {
    Limits.checkAngle("heading", heading);
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

  /** Puts it back to its start, free for any operator. */
  public void reset() {
    simulator.carryOut(new Control.Reset(number));
  }

  /** Switches it on or off. */
  public void power(boolean on) {
    simulator.carryOut(new Control.Power(number, on));
  }

  /** What is really so now; nothing of it is on the wire. */
  public DroneTruth truth() {
    simulator.settle();
    return simulator.monitor().truth(number);
  }

  /** What came to it, and what it answered. */
  public Journal journal() {
    return journal;
  }

  /**
   * A program that shall fly it, such as {@code program("python3", "fly.py", "{host}",
   * "{commandPort}")}.
   *
   * @param command program and arguments, in which {@code {host}}, {@code {commandPort}}, {@code
   *     {statePort}} and {@code {videoPort}} stand for this drone's
   * @return which is to be {@link OperatorProgram#run run}; a test that forgets it fails
   * @throws IllegalArgumentException if a word is a placeholder that is none of these
   */
  public OperatorProgram program(String... command) {
    if (command.length == 0) {
      throw new IllegalArgumentException("command is empty, but must name a program");
    }
    OperatorProgram program = new OperatorProgram(List.of(command), this, simulator::started);
    simulator.named(program);
    return program;
  }

  /** See {@link TelloSimulator#awaitFalls}. */
  void awaitFalls() {
    simulator.awaitFalls();
  }

  /** What goes wrong with it, each in a line. */
  List<String> faults() {
    return simulator.snapshot().drones().get(number - 1).faults().faults().stream()
        .map(Fault::toString)
        .toList();
  }

  /** The names of the gates through which it can fly. */
  List<String> gates() {
    return simulator.monitor().gates();
  }

  @Override
  public String toString() {
    return "drone " + number;
  }
}
