package tellosimulator.web;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import tellosimulator.goal.Challenge;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.pilot.DemoTour;
import tellosimulator.pilot.GoalRoute;
import tellosimulator.pilot.OperatorSocket;
import tellosimulator.pilot.ScriptedFlight;
import tellosimulator.sim.SimSnapshot;

/**
 * Sends commands of pages to the drones' command ports, as any operator program does. Thread-safe.
 */
final class WebPilot implements AutoCloseable {

  /** The commands with which people fly by hand. */
  private static final Pattern COMMAND =
      Pattern.compile("takeoff|land|stop|emergency|flip [lrfb]|rc( -?[0-9]{1,3}){4}");

  private final Map<InetSocketAddress, OperatorSocket> sockets = new HashMap<>();
  private Optional<ScriptedFlight> demo = Optional.empty();

  /**
   * Sends a command, and does not wait for the reply, which is part of the state. Ends a demo.
   *
   * @throws IllegalArgumentException if it is not a command for flying by hand
   * @throws IllegalStateException if the drone cannot be reached; the message is one sentence
   */
  synchronized void send(OnlineSimulation simulation, int drone, String command) {
    if (!COMMAND.matcher(command).matches()) {
      throw new IllegalArgumentException(
          "the page flies only with takeoff, land, stop, emergency, flip and rc");
    }
    endDemo();
    InetSocketAddress address = simulation.addresses(drone).get(0);
    try {
      OperatorSocket socket = socket(address);
      if (simulation.snapshot().drones().get(drone - 1).link().operator().isEmpty()) {
        socket.send("command");
      }
      socket.send(command);
    } catch (IOException e) {
      Optional.ofNullable(sockets.remove(address)).ifPresent(OperatorSocket::close);
      throw unreachable(drone, e);
    }
  }

  private static IllegalStateException unreachable(int drone, IOException e) {
    return new IllegalStateException("drone " + drone + " cannot be reached: switch it on", e);
  }

  private OperatorSocket socket(InetSocketAddress address) throws IOException {
    OperatorSocket known = sockets.get(address);
    if (known == null) {
      known = OperatorSocket.open(address);
      sockets.put(address, known);
    }
    while (known.receive().isPresent()) {
      // the state has the reply; it must not fill the buffer
    }
    return known;
  }

  /**
   * Flies the goals of a challenge, or a tour if that is impossible. If a demo is running, ends it.
   *
   * @throws IllegalStateException if the drone is not standing, or cannot be reached; the message
   *     is one sentence
   */
  synchronized void demo(OnlineSimulation simulation, Challenge challenge, int drone) {
    if (endDemo()) {
      return;
    }
    SimSnapshot snapshot = simulation.snapshot();
    if (snapshot.drones().get(drone - 1).state().phase().flying()) {
      throw new IllegalStateException("the drone is in the air: land it first");
    }
    List<String> commands =
        GoalRoute.commands(challenge, snapshot, drone)
            .orElseGet(() -> new DemoTour(snapshot, drone).commands());
    try {
      InetSocketAddress address = simulation.addresses(drone).get(0);
      demo = Optional.of(new ScriptedFlight(address, commands, () -> simulation.time().nanos()));
    } catch (IOException e) {
      throw unreachable(drone, e);
    }
  }

  /** Whether a demo is running. */
  synchronized boolean fliesDemo() {
    return demo.filter(flight -> !flight.ended()).isPresent();
  }

  private boolean endDemo() {
    boolean running = fliesDemo();
    demo.ifPresent(ScriptedFlight::close);
    demo = Optional.empty();
    return running;
  }

  @Override
  public synchronized void close() {
    endDemo();
    sockets.values().forEach(OperatorSocket::close);
    sockets.clear();
  }
}
