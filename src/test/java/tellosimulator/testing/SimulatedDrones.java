package tellosimulator.testing;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.model.DroneState;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimListener;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.time.SimTime;

/**
 * All drones of a configuration, switched on, for a test that sends commands and steps simulated
 * time: no sockets, no threads, no waiting.
 */
public final class SimulatedDrones {

  /** Longest simulated time to wait for replies [s]. */
  private static final double PATIENCE = 60;

  private static final int OPERATORS_PORT = 9000;

  private final Simulation simulation;
  private final int count;
  private final Map<Integer, List<String>> replies = new HashMap<>();

  /**
   * @param listeners are notified of all events
   */
  public SimulatedDrones(SimConfig config, List<SimListener> listeners) {
    count = config.drones().size();
    for (int drone = 1; drone <= count; drone++) {
      replies.put(drone, new ArrayList<>());
    }
    simulation =
        new Simulation(
            config,
            drone -> TextPort.replies(text -> replies.get(drone).add(text.strip())),
            listeners);
    all().forEach(drone -> control(new Control.Power(drone, true)));
  }

  /** Sends commands to the first drone, each after the reply to the previous one. */
  public List<String> fly(String... commands) {
    return fly(1, commands);
  }

  /** Sends commands to a drone, each after the reply to the previous one. */
  public List<String> fly(int drone, String... commands) {
    List<String> answers = new ArrayList<>();
    for (String command : commands) {
      answers.add(ask(drone, command));
    }
    return answers;
  }

  /** Sends a command and advances time until the reply. */
  public String ask(int drone, String command) {
    int before = replies.get(drone).size();
    send(drone, command);
    await(() -> replies.get(drone).size() > before, "`" + command + "` to drone " + drone);
    return replies.get(drone).get(before);
  }

  /** Sends commands to all drones, each after all have answered the previous one. */
  public void flyAll(String... commands) {
    for (String command : commands) {
      flyTogether(all().stream().map(drone -> command).toList());
    }
  }

  /** Sends each drone its own command, and advances time until all have answered. */
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

  /** Delivers a datagram. */
  public void send(int drone, String command) {
    Peer peer =
        new Peer(SteppedDrone.address("192.168.10.100", OPERATORS_PORT + drone), address(drone));
    simulation.submit(drone, peer, WireText.encode(command));
    simulation.drain();
  }

  /** Applies a control. */
  public void control(Control control) {
    simulation.control(control);
    simulation.drain();
  }

  /** Advances simulated time. */
  public void advance(double seconds) {
    long steps = Math.round(seconds / SimTime.STEP);
    for (long i = 0; i < steps; i++) {
      simulation.step();
    }
  }

  /** Returns a drone at the end of the last step. */
  public DroneState state(int drone) {
    return simulation.snapshot().drones().get(drone - 1).state();
  }

  /** Returns all drones at the end of the last step. */
  public SimSnapshot snapshot() {
    return simulation.snapshot();
  }

  private void await(BooleanSupplier reached, String what) {
    double end = simulation.snapshot().time().seconds() + PATIENCE;
    while (!reached.getAsBoolean()) {
      if (simulation.snapshot().time().seconds() > end) {
        throw new AssertionError("no reply to " + what + " within " + PATIENCE + " s");
      }
      simulation.step();
    }
  }

  private List<Integer> all() {
    return IntStream.rangeClosed(1, count).boxed().toList();
  }

  private static InetSocketAddress address(int drone) {
    return SteppedDrone.address("192.168.10." + drone, 8889);
  }
}
