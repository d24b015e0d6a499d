package tellosimulator.testing;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import tellosimulator.command.Peer;
import tellosimulator.model.DroneState;
import tellosimulator.network.CommandResponseSender;
import tellosimulator.network.Ports;
import tellosimulator.network.StateConnection;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;

/**
 * All drones of a configuration, switched on, that a test talks to and whose time it steps: no
 * sockets, no threads, no waiting.
 */
public final class SimulatedDrones {

  /** Longest simulated time that replies are waited for [s]. */
  private static final double PATIENCE = 60;

  private static final int OPERATORS_PORT = 9000;

  private final Simulation simulation;
  private final int count;
  private final Map<Integer, InMemoryPort> ports = new HashMap<>();
  private final Map<Integer, List<String>> replies = new HashMap<>();

  /**
   * @param listeners are told what happens
   */
  public SimulatedDrones(SimConfig config, List<SimListener> listeners) {
    count = config.drones().size();
    for (int drone = 1; drone <= count; drone++) {
      ports.put(drone, new InMemoryPort(address(drone)));
      replies.put(drone, new ArrayList<>());
    }
    simulation =
        new Simulation(
            config,
            drone ->
                new CommandResponseSender(
                    new Ports(List.of(ports.get(drone))), OptionalInt.empty()),
            new StateConnection(new Ports(List.of())),
            listeners);
    all().forEach(drone -> control(new Control.Power(drone, true)));
  }

  /** Lets the first drone carry out commands, each after the reply to the one before. */
  public List<String> fly(String... commands) {
    return fly(1, commands);
  }

  /** Lets a drone carry out commands, each after the reply to the one before. */
  public List<String> fly(int drone, String... commands) {
    List<String> answers = new ArrayList<>();
    for (String command : commands) {
      answers.add(ask(drone, command));
    }
    return answers;
  }

  /** Sends a command and lets time pass until the reply comes. */
  public String ask(int drone, String command) {
    int before = replies.get(drone).size();
    send(drone, command);
    await(() -> replies.get(drone).size() > before, "`" + command + "` to drone " + drone);
    return replies.get(drone).get(before);
  }

  /** Lets all drones carry out commands, each after all have answered the one before. */
  public void flyAll(String... commands) {
    for (String command : commands) {
      flyTogether(all().stream().map(drone -> command).toList());
    }
  }

  /** Sends each drone a command of its own, and lets time pass until all have answered. */
  public void flyTogether(List<String> commands) {
    Map<Integer, Integer> before = new HashMap<>();
    for (int i = 0; i < commands.size(); i++) {
      before.put(i + 1, replies.get(i + 1).size());
      send(i + 1, commands.get(i));
    }
    await(
        () ->
            before.entrySet().stream()
                .allMatch(entry -> replies.get(entry.getKey()).size() > entry.getValue()),
        String.valueOf(commands));
  }

  /** A datagram arrives. */
  public void send(int drone, String command) {
    Peer peer =
        new Peer(SteppedDrone.address("192.168.10.100", OPERATORS_PORT + drone), address(drone));
    simulation.submit(drone, peer, command);
    simulation.drain();
    collect();
  }

  /** A person does something. */
  public void control(Control control) {
    simulation.control(control);
    simulation.drain();
    collect();
  }

  /** Lets simulated time pass. */
  public void advance(double seconds) {
    long steps = Math.round(seconds / SimTime.STEP);
    for (long i = 0; i < steps; i++) {
      step();
    }
  }

  /** A drone at the end of the last step. */
  public DroneState state(int drone) {
    return simulation.snapshot().drones().get(drone - 1).state();
  }

  /** All drones at the end of the last step. */
  public SimSnapshot snapshot() {
    return simulation.snapshot();
  }

  private void await(BooleanSupplier reached, String what) {
    double end = simulation.snapshot().time().seconds() + PATIENCE;
    while (!reached.getAsBoolean()) {
      if (simulation.snapshot().time().seconds() > end) {
        throw new AssertionError("no reply to " + what + " within " + PATIENCE + " s");
      }
      step();
    }
  }

  private void step() {
    simulation.step();
    collect();
  }

  private void collect() {
    ports.forEach(
        (drone, port) ->
            port.takeSent().forEach(sent -> replies.get(drone).add(sent.text().strip())));
  }

  private List<Integer> all() {
    return IntStream.rangeClosed(1, count).boxed().toList();
  }

  private static InetSocketAddress address(int drone) {
    return SteppedDrone.address("192.168.10." + drone, 8889);
  }
}
